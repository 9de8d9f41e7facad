#include "vtkDistributedFieldAlgorithm.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialRanks.h"
#include "vtkMedialRequests.h"
#include "vtkMultiProcessController.h"

//------------------------------------------------------------------------------
vtkDistributedFieldAlgorithm::vtkDistributedFieldAlgorithm()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkDistributedFieldAlgorithm::~vtkDistributedFieldAlgorithm() = default;

//------------------------------------------------------------------------------
vtkCxxSetSmartPointerMacro(vtkDistributedFieldAlgorithm, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkDistributedFieldAlgorithm::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
void vtkDistributedFieldAlgorithm::Modified()
{
  this->FillInputPortInformation(0, this->GetInputPortInformation(0));
  this->Superclass::Modified();
}

//------------------------------------------------------------------------------
int vtkDistributedFieldAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  vtkAcceptSurface(info, this->DistributedInput != 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkDistributedFieldAlgorithm::RequestUpdateExtent(vtkInformation*,
  vtkInformationVector** inputVector, vtkInformationVector*)
{
  // Unless the surface is distributed, this process is a rank on its own and gets the whole.
  const vtkMedialRanks ranks(this->DistributedInput ? this->Controller.Get() : nullptr);
  vtkRequestPiece(inputVector[0]->GetInformationObject(0), ranks.rank(), ranks.size());
  return 1;
}

//------------------------------------------------------------------------------
void vtkDistributedFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistributedInput: " << (this->DistributedInput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
