#include "vtkMeshFieldAlgorithm.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataPipeline.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialEnumerations.h"
#include "vtkMedialExecution.h"
#include "vtkMedialRequests.h"
#include "vtkMeshFieldInternals.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <exception>
#include <optional>

namespace
{

//------------------------------------------------------------------------------
// The pipeline marks outputs this way while it goes through the blocks of composite input.
class BlockKey : public vtkCompositeDataPipeline
{
public:
  static bool IsSet(vtkInformation* outInfo) { return outInfo->Has(SUPPRESS_RESET_PI()) != 0; }
};

} // namespace

//------------------------------------------------------------------------------
vtkMeshFieldAlgorithm::vtkMeshFieldAlgorithm()
  : Internals(new vtkInternals(this))
{
  this->SetNumberOfInputPorts(1);
}

//------------------------------------------------------------------------------
vtkMeshFieldAlgorithm::~vtkMeshFieldAlgorithm() = default;

//------------------------------------------------------------------------------
vtkTypeBool vtkMeshFieldAlgorithm::ProcessRequest(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    this->Internals->InputIsBlock = BlockKey::IsSet(outputVector->GetInformationObject(0));
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    this->Internals->Refusal = nullptr;
    return this->RequestInformation(request, inputVector, outputVector);
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    return this->RequestUpdateExtent(request, inputVector, outputVector);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->Internals->Refusal ? this->RefuseData(outputVector)
                                    : this->RequestData(request, inputVector, outputVector);
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::SetInputData(vtkDataObject* input)
{
  this->SetInputDataInternal(0, input);
}

//------------------------------------------------------------------------------
int vtkMeshFieldAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshFieldAlgorithm::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector*)
{
  vtkRequestWhole(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshFieldAlgorithm::RequestImageInformation(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector, int port)
{
  return this->Internals->AnnounceImage(outputVector, port,
    [&]() -> std::optional<medial::Grid>
    {
      vtkPolyData* input = nullptr;
      if (this->GridMode != EXPLICIT)
      {
        input = this->UpdateWholeInput(inputVector);
        if (!input)
        {
          return std::nullopt;
        }
      }
      return this->Internals->MakeGrid(input);
    });
}

//------------------------------------------------------------------------------
// VTK does not ask again for information that was refused: the next update takes it as given, and
// filters downstream read the extent without a check. So a refusal announces an image of a point,
// and is repeated where the data are asked for.
int vtkMeshFieldAlgorithm::RefuseData(vtkInformationVector* outputVector)
{
  this->Internals->Try([&] { std::rethrow_exception(this->Internals->Refusal); });
  return vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
// Asks for what RequestUpdateExtent() asks for, so that the input is not executed twice. A block of
// composite input is up to date already, and its producer is still executing. Returns null if the
// input itself is composite.
vtkPolyData* vtkMeshFieldAlgorithm::UpdateWholeInput(vtkInformationVector** inputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (!input || this->Internals->InputIsBlock)
  {
    return input;
  }
  vtkUpdateInput(this, 0, 1);
  return vtkPolyData::GetData(inputVector[0]);
}

//------------------------------------------------------------------------------
// The macro of VTK modifies the filter even where nothing changes.
void vtkMeshFieldAlgorithm::SetDevice(const char* device)
{
  const std::string name = device ? device : "";
  if (this->Device != name)
  {
    this->Device = name;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkMeshFieldAlgorithm::GetGridModeAsString()
{
  return vtkMedialGridModes.NameOf(this->GridMode);
}

//------------------------------------------------------------------------------
const char* vtkMeshFieldAlgorithm::GetSignMethodAsString()
{
  return vtkMedialSignMethods.NameOf(this->SignMethod);
}

//------------------------------------------------------------------------------
const char* vtkMeshFieldAlgorithm::GetEngineAsString()
{
  return vtkMedialEngines.NameOf(this->Engine);
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [&](const char* name, const auto& values) {
    os << indent << name << ": (" << values[0] << ", " << values[1] << ", " << values[2] << ")\n";
  };
  const auto flag = [&](const char* name, vtkTypeBool value)
  { os << indent << name << ": " << (value ? "On" : "Off") << "\n"; };
  os << indent << "GridMode: " << this->GetGridModeAsString() << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  vector("Spacing", this->Spacing);
  vector("Origin", this->Origin);
  vector("Dimensions", this->Dimensions);
  os << indent << "Padding: " << this->Padding << "\n";
  os << indent << "SignMethod: " << this->GetSignMethodAsString() << "\n";
  os << indent << "Engine: " << this->GetEngineAsString() << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "Device: " << this->Device << "\n";
  flag("RequireHardware", this->RequireHardware);
  flag("GenerateClosestPoint", this->GenerateClosestPoint);
  flag("GenerateClosestCell", this->GenerateClosestCell);
  flag("GenerateClosestFeature", this->GenerateClosestFeature);
  flag("GenerateClosestSite", this->GenerateClosestSite);
}
