#include "vtkMedialProgress.h"

#include "vtkAlgorithm.h"
#include "vtkMedialExecution.h"

#include "medial/error.h"

//------------------------------------------------------------------------------
vtkProgressBridge::vtkProgressBridge(vtkAlgorithm* algorithm)
  : Algorithm(algorithm)
{
#if MEDIAL_VTK_ABORTS_OUTPUTS
  algorithm->AbortExecute = 0;
#endif
}

//------------------------------------------------------------------------------
void vtkProgressBridge::report(double fraction, const char* phase)
{
  this->Algorithm->SetProgressText(phase);
  this->Algorithm->UpdateProgress(fraction);
}

//------------------------------------------------------------------------------
bool vtkProgressBridge::cancelled()
{
  return this->Algorithm->GetAbortExecute() != 0;
}

//------------------------------------------------------------------------------
void vtkProgressBridge::ReportOrStop(double fraction, const char* phase)
{
  this->report(fraction, phase);
  if (this->cancelled())
  {
    throw medial::Error(medial::ErrorCode::Cancelled, "cancelled");
  }
}

//------------------------------------------------------------------------------
void vtkProgressPart::report(double fraction, const char* phase)
{
  this->Bridge.report(this->From + fraction * (this->To - this->From), phase);
}
