#include "vtkDistributedFieldAlgorithm.h"

#include "vtkAlgorithm.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkMedialRanks.h"
#include "vtkMultiProcessController.h"

//------------------------------------------------------------------------------
vtkDistributedFieldAlgorithm::vtkDistributedFieldAlgorithm()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkDistributedFieldAlgorithm::~vtkDistributedFieldAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkDistributedFieldAlgorithm::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

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
int vtkDistributedFieldAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (!this->Superclass::FillInputPortInformation(port, info))
  {
    return 0;
  }
  if (this->DistributedInput)
  {
    vtkAcceptPieces(info);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkDistributedFieldAlgorithm::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->DistributedInput)
  {
    return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  }
  const vtkMedialRanks ranks(this->Controller);
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
