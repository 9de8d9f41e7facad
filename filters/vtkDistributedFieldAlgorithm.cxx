#include "vtkDistributedFieldAlgorithm.h"

#include "vtkDistributedInput.h"
#include "vtkMultiProcessController.h"

//------------------------------------------------------------------------------
vtkDistributedFieldAlgorithm::vtkDistributedFieldAlgorithm()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkDistributedFieldAlgorithm::~vtkDistributedFieldAlgorithm() = default;

//------------------------------------------------------------------------------
vtkCxxDistributedInputMacro(vtkDistributedFieldAlgorithm);

//------------------------------------------------------------------------------
void vtkDistributedFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistributedInput: " << (this->DistributedInput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
