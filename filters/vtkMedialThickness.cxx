#include "vtkMedialThickness.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/thickness.h"

vtkStandardNewMacro(vtkMedialThickness);

//------------------------------------------------------------------------------
vtkMedialThickness::vtkMedialThickness() = default;

//------------------------------------------------------------------------------
vtkMedialThickness::~vtkMedialThickness() = default;

//------------------------------------------------------------------------------
const char* vtkMedialThickness::GetSideAsString()
{
  return vtkSideAsString<vtkMedialThickness>(this->Side);
}

//------------------------------------------------------------------------------
int vtkMedialThickness::RequestInformation(vtkInformation*, vtkInformationVector**,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialThickness::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector*)
{
  vtkRequestWhole(inputVector[0]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
void vtkMedialThickness::ForgetFigures()
{
  this->MinThickness = 0.0;
  this->MedianThickness = 0.0;
  this->MaxThickness = 0.0;
  this->ShareWithout = 0.0;
}

//------------------------------------------------------------------------------
void vtkMedialThickness::Execute(vtkPolyData* input, vtkPolyData* output)
{
  if (!input)
  {
    throw medial::Error(medial::ErrorCode::InvalidInput, "the input is not a vtkPolyData");
  }
  if (this->NumberOfThreads < 0)
  {
    vtkThrowBadParameter("NumberOfThreads", this->NumberOfThreads, ">= 0");
  }
  vtkProgressBridge progress(this);
  medial::ThicknessOptions options;
  options.angle = this->Angle;
  options.side = vtkToSide<vtkMedialThickness>(this->Side);
  options.execution.threads = this->NumberOfThreads;
  options.execution.progress = &progress;
  const medial::TriangleMesh mesh =
    medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(input));
  const medial::Thickness thickness = medial::computeThickness(mesh, options);
  output->ShallowCopy(input);
  vtkMeshConversion::AddThickness(thickness, mesh, output);
  this->MinThickness = thickness.min;
  this->MedianThickness = thickness.median;
  this->MaxThickness = thickness.max;
  this->ShareWithout = thickness.shareWithout();
}

//------------------------------------------------------------------------------
int vtkMedialThickness::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  this->ErrorCode = vtkErrorCode::NoError;
  this->ForgetFigures();
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  const bool done = vtkRunGuarded(this, this->ErrorCode,
    [&] { this->Execute(vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(outInfo)); });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "Side: " << this->GetSideAsString() << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "MinThickness: " << this->MinThickness << "\n";
  os << indent << "MedianThickness: " << this->MedianThickness << "\n";
  os << indent << "MaxThickness: " << this->MaxThickness << "\n";
  os << indent << "ShareWithout: " << this->ShareWithout << "\n";
}
