#include "vtkMedialAxis.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialEnumerations.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialProgress.h"
#include "vtkMedialRanks.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfacePiece.h"

#include "medial/error.h"
#include "medial/ranks.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMedialAxis);

namespace
{

constexpr vtkMedialEnumeration<medial::Representation, 3> RepresentationValues = { "Representation",
  {
    { vtkMedialAxis::SURFACE, medial::Representation::Surface, "Surface" },
    { vtkMedialAxis::FACES, medial::Representation::Faces, "Faces" },
    { vtkMedialAxis::POINTS, medial::Representation::Points, "Points" },
  } };

constexpr vtkMedialEnumeration<medial::Topology, 2> TopologyValues = { "Topology",
  {
    { vtkMedialAxis::SELECTED, medial::Topology::Selected, "Selected" },
    { vtkMedialAxis::PRESERVE, medial::Topology::Preserve, "Preserve" },
  } };

//------------------------------------------------------------------------------
// The options of the axis; those of the field are not set.
medial::MedialAxisOptions ToOptions(vtkMedialAxis* axis)
{
  medial::MedialAxisOptions options;
  options.angle = axis->GetAngle();
  options.lambda = axis->GetMinimumLambda();
  options.radius = axis->GetMinimumRadius();
  options.side = vtkMedialSides.ToLibrary(axis->GetSide());
  options.representation = RepresentationValues.ToLibrary(axis->GetRepresentation());
  options.maxSpheres = axis->GetMaximumNumberOfSpheres();
  options.topology = TopologyValues.ToLibrary(axis->GetTopology());
  return options;
}

//------------------------------------------------------------------------------
// The parameters of the axis that must be the same on all ranks, a line with a name and a value
// each.
std::string DescribeAxis(vtkMedialAxis* axis)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "Angle " << axis->GetAngle() << "\nMinimumLambda " << axis->GetMinimumLambda()
       << "\nMinimumRadius " << axis->GetMinimumRadius() << "\nSide " << axis->GetSideAsString()
       << "\nRepresentation " << axis->GetRepresentationAsString() << "\nMaximumNumberOfSpheres "
       << axis->GetMaximumNumberOfSpheres() << "\nTopology " << axis->GetTopologyAsString()
       << "\nGenerateDistanceField " << axis->GetGenerateDistanceField() << '\n';
  return text.str();
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
const char* vtkMedialAxis::GetSideAsString()
{
  return vtkMedialSides.NameOf(this->Side);
}

//------------------------------------------------------------------------------
const char* vtkMedialAxis::GetRepresentationAsString()
{
  return RepresentationValues.NameOf(this->Representation);
}

//------------------------------------------------------------------------------
const char* vtkMedialAxis::GetTopologyAsString()
{
  return TopologyValues.NameOf(this->Topology);
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
  if (this->GenerateDistanceField && !this->DistributedInput)
  {
    return this->RequestImageInformation(inputVector, outputVector, 1);
  }
  const int nothing[6] = { 0, -1, 0, -1, 0, -1 };
  outputVector->GetInformationObject(1)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(),
    nothing, 6);
  return 1;
}

//------------------------------------------------------------------------------
void vtkMedialAxis::Execute(vtkPolyData* input, vtkInformationVector* outputVector)
{
  vtkProgressBridge progress(this);
  medial::MedialAxisOptions options = ToOptions(this);
  options.field = this->Internals->MakeOptions(progress);
  this->Internals->UpdateMesh(input, options.field.execution);
  vtkInformation* imageInfo = outputVector->GetInformationObject(1);
  vtkImageData* image = vtkImageData::GetData(imageInfo);
  medial::Grid grid;
  medial::FieldArrays arrays;
  if (this->GenerateDistanceField)
  {
    grid = vtkInternals::AnnouncedGrid(imageInfo);
    arrays = vtkMeshConversion::AllocateField(image, grid, grid.wholeExtent(),
      this->Internals->MakeSelection());
  }
  else
  {
    grid = this->Internals->MakeGrid(input);
  }
  const medial::MedialAxis axis = medial::computeMedialAxis(this->Internals->Mesh,
    this->Internals->Connectivity, grid, options, arrays);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkMeshConversion::ToPolyData(axis, output);
  const auto record = [&](vtkDataObject* data)
  {
    this->Internals->Record(grid, axis.statistics, data);
    vtkMedialFigures(data).AddText("Side", vtkMedialSides.NameOfLibrary(axis.side));
  };
  record(output);
  if (this->GenerateDistanceField)
  {
    record(image);
  }
  vtkWarnOnce(this, axis.statistics.note);
}

//------------------------------------------------------------------------------
// Each rank makes its part of the axis of all inputs. Who asks for the whole, as filters do that
// work on one process alone, gets all of it on the first.
void vtkMedialAxis::ExecutePieces(vtkDataObject* input, vtkInformationVector* outputVector)
{
  vtkProgressBridge progress(this);
  medial::MedialAxisOptions options;
  vtkSurfacePiece piece;
  vtkMedialRanks ranks(this->Controller);
  const std::vector<vtkPieceFacts> facts =
    ranks.Meet(vtkMedialRanks::Stage::Data, this->Internals->DescribeOptions() + DescribeAxis(this),
      [&]
      {
        if (this->GenerateDistanceField)
        {
          throw medial::Error(medial::ErrorCode::InvalidInput,
            "GenerateDistanceField must be off where DistributedInput is on: vtkMeshDistanceField "
            "makes the field in pieces");
        }
        options = ToOptions(this);
        options.field = this->Internals->MakeOptions(progress);
        piece = vtkSurfacePiece(input);
        return piece.Facts();
      });
  const bool whole = outputVector->GetInformationObject(0)->Get(
                       vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()) == 1;
  medial::agree(ranks,
    [&]
    {
      const medial::Grid grid = this->Internals->MakeGrid(
        this->GridMode == EXPLICIT ? medial::Bounds{} : vtkMedialRanks::BoundsOf(facts));
      const medial::SurfacePiece surface = piece.Numbered(ranks, facts);
      medial::NoField field;
      medial::RankCounts counts;
      medial::AxisPiece axis = medial::computeMedialAxis(ranks, surface, grid,
        medial::partsByWork(ranks, surface, grid, options.field, options.side), field, options,
        &counts);
      if (whole && ranks.size() > 1)
      {
        axis = medial::onlyPiece(medial::gatherMedialAxis(ranks, axis));
      }
      vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
      vtkMeshConversion::ToPolyData(axis, output);
      this->Internals->Record(grid, axis.axis.statistics, output, false);
      vtkMedialFigures figures(output);
      figures.AddRankCounts(counts);
      figures.AddText("Side", vtkMedialSides.NameOfLibrary(axis.axis.side));
    });
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
      vtkInternals::Begin(outputVector);
      if (this->DistributedInput)
      {
        this->ExecutePieces(vtkDataObject::GetData(inputVector[0]), outputVector);
      }
      else if (piece <= 0)
      {
        this->Execute(vtkPolyData::GetData(inputVector[0]), outputVector);
      }
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
