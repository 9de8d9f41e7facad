#include "vtkMedialAxis.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkMedialAxis);

namespace
{

//------------------------------------------------------------------------------
medial::Representation ToRepresentation(int representation)
{
  switch (representation)
  {
    case vtkMedialAxis::SURFACE:
      return medial::Representation::Surface;
    case vtkMedialAxis::FACES:
      return medial::Representation::Faces;
    case vtkMedialAxis::POINTS:
      return medial::Representation::Points;
    default:
      vtkThrowBadParameter("Representation", representation,
        "one of 0 (surface), 1 (faces), 2 (points)");
  }
}

//------------------------------------------------------------------------------
medial::Topology ToTopology(int topology)
{
  switch (topology)
  {
    case vtkMedialAxis::SELECTED:
      return medial::Topology::Selected;
    case vtkMedialAxis::PRESERVE:
      return medial::Topology::Preserve;
    default:
      vtkThrowBadParameter("Topology", topology, "one of 0 (selected), 1 (preserve)");
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialAxis::vtkMedialAxis()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkMedialAxis::~vtkMedialAxis() = default;

//------------------------------------------------------------------------------
vtkPolyData* vtkMedialAxis::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
vtkImageData* vtkMedialAxis::GetDistanceField()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkMedialAxis::GetUsedSide()
{
  switch (this->Internals->Last.Side)
  {
    case medial::Side::Interior:
      return INTERIOR;
    case medial::Side::Exterior:
      return EXTERIOR;
    case medial::Side::Both:
      break;
  }
  return BOTH;
}

//------------------------------------------------------------------------------
const char* vtkMedialAxis::GetSideAsString()
{
  return vtkSideAsString<vtkMedialAxis>(this->Side);
}

//------------------------------------------------------------------------------
const char* vtkMedialAxis::GetRepresentationAsString()
{
  switch (this->Representation)
  {
    case SURFACE:
      return "Surface";
    case FACES:
      return "Faces";
    case POINTS:
      return "Points";
    default:
      return "Unknown";
  }
}

//------------------------------------------------------------------------------
const char* vtkMedialAxis::GetTopologyAsString()
{
  switch (this->Topology)
  {
    case SELECTED:
      return "Selected";
    case PRESERVE:
      return "Preserve";
    default:
      return "Unknown";
  }
}

//------------------------------------------------------------------------------
int vtkMedialAxis::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialAxis::RequestInformation(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  if (this->GenerateDistanceField)
  {
    return this->RequestImageInformation(inputVector, outputVector, 1);
  }
  const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
  outputVector->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(),
    nothing, 6);
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialAxis::RequestData(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  const int piece = outputVector->GetInformationObject(port)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const bool done = this->Internals->Try(
    [&]
    {
      this->Internals->Begin(outputVector);
      if (piece > 0)
      {
        return;
      }
      vtkProgressBridge progress(this);
      medial::MedialAxisOptions options;
      options.angle = this->Angle;
      options.lambda = this->MinimumLambda;
      options.radius = this->MinimumRadius;
      options.side = vtkToSide<vtkMedialAxis>(this->Side);
      options.representation = ToRepresentation(this->Representation);
      options.maxSpheres = this->MaximumNumberOfSpheres;
      options.topology = ToTopology(this->Topology);
      options.field = this->Internals->MakeOptions(&progress);

      vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
      this->Internals->UpdateMesh(input);
      vtkInformation* imageInfo = outputVector->GetInformationObject(1);
      medial::Grid grid;
      medial::FieldArrays arrays;
      if (this->GenerateDistanceField)
      {
        grid = vtkInternals::AnnouncedGrid(imageInfo);
        arrays = vtkMeshConversion::AllocateField(vtkImageData::GetData(imageInfo), grid,
          grid.wholeExtent(), this->Internals->MakeSelection());
      }
      else
      {
        grid = this->Internals->MakeGrid(input);
      }

      const medial::MedialAxis axis = medial::computeMedialAxis(this->Internals->Mesh,
        this->Internals->Connectivity, grid, options, arrays);
      vtkMeshConversion::ToPolyData(axis, vtkPolyData::GetData(outputVector, 0));
      this->Internals->Record(grid, axis.sign, axis.statistics);
      this->Internals->Last.Side = axis.side;
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialAxis::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "MinimumLambda: " << this->MinimumLambda << "\n";
  os << indent << "MinimumRadius: " << this->MinimumRadius << "\n";
  os << indent << "Side: " << this->GetSideAsString() << "\n";
  os << indent << "Representation: " << this->GetRepresentationAsString() << "\n";
  os << indent << "MaximumNumberOfSpheres: " << this->MaximumNumberOfSpheres << "\n";
  os << indent << "Topology: " << this->GetTopologyAsString() << "\n";
  os << indent << "GenerateDistanceField: " << (this->GenerateDistanceField ? "On" : "Off") << "\n";
}
