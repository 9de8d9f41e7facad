#include "vtkMedialPolyDataAlgorithm.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/error.h"

//------------------------------------------------------------------------------
vtkMedialPolyDataAlgorithm::vtkMedialPolyDataAlgorithm() = default;

//------------------------------------------------------------------------------
vtkMedialPolyDataAlgorithm::~vtkMedialPolyDataAlgorithm() = default;

//------------------------------------------------------------------------------
int vtkMedialPolyDataAlgorithm::RequestInformation(vtkInformation*, vtkInformationVector**,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialPolyDataAlgorithm::RequestUpdateExtent(vtkInformation*,
  vtkInformationVector** inputVector, vtkInformationVector*)
{
  vtkRequestWhole(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialPolyDataAlgorithm::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  // Assigned, since SetErrorCode() would modify the filter while it executes.
  this->ErrorCode = vtkErrorCode::NoError;
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  const bool done = vtkRunGuarded(this, this->ErrorCode,
    [&]
    {
      vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
      if (!input)
      {
        throw medial::Error(medial::ErrorCode::InvalidInput, "the input is not a vtkPolyData");
      }
      this->Execute(input, vtkPolyData::GetData(outInfo));
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialPolyDataAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
