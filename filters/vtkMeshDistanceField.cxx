#include "vtkMeshDistanceField.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialRanks.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfacePiece.h"

#include "medial/compute_distance_field.h"
#include "medial/error.h"

#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
// Writes slabs into the arrays of an extent.
class ExtentSink : public medial::FieldSink
{
public:
  ExtentSink(const medial::Extent& extent, const medial::FieldArrays& arrays)
    : Extent(extent)
    , Arrays(arrays)
  {
  }

  medial::FieldArrays slabArrays(const medial::Extent& slab) override
  {
    const std::ptrdiff_t first = static_cast<std::ptrdiff_t>(slab.min[2] - this->Extent.min[2]) *
      this->Extent.size(0) * this->Extent.size(1);
    const auto from = [](auto* array, std::ptrdiff_t value)
    { return array ? array + value : nullptr; };
    medial::FieldArrays arrays;
    arrays.distance = from(this->Arrays.distance, first);
    arrays.closestPoint = from(this->Arrays.closestPoint, 3 * first);
    arrays.closestSite = from(this->Arrays.closestSite, first);
    arrays.closestFeature = from(this->Arrays.closestFeature, first);
    arrays.closestCell = from(this->Arrays.closestCell, first);
    return arrays;
  }

  void stored(const medial::Extent&) override {}
  std::size_t bytesPerPoint() const override { return 0; }

private:
  medial::Extent Extent;
  medial::FieldArrays Arrays;
};

//------------------------------------------------------------------------------
// The bounds of all pieces. Throws if they are empty.
medial::Bounds BoundsOf(const std::vector<vtkPieceFacts>& pieces)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  medial::Bounds bounds{ { far, far, far }, { -far, -far, -far } };
  bool empty = true;
  for (const vtkPieceFacts& piece : pieces)
  {
    empty = empty && piece.Empty;
    for (int axis = 0; axis < 3 && !piece.Empty; ++axis)
    {
      bounds.min[axis] = std::min(bounds.min[axis], piece.Bounds.min[axis]);
      bounds.max[axis] = std::max(bounds.max[axis], piece.Bounds.max[axis]);
    }
  }
  if (empty)
  {
    throw medial::Error(medial::ErrorCode::InvalidInput, "the mesh has no cells");
  }
  return bounds;
}

//------------------------------------------------------------------------------
// What must be the same on all ranks, a line each.
std::string OptionsOf(vtkMeshDistanceField* filter)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  const auto vector = [&text](const char* name, const auto* values)
  { text << name << ' ' << values[0] << ' ' << values[1] << ' ' << values[2] << '\n'; };
  text << "GridMode " << filter->GetGridModeAsString() << "\nResolution " << filter->GetResolution()
       << '\n';
  vector("Spacing", filter->GetSpacing());
  vector("Origin", filter->GetOrigin());
  vector("Dimensions", filter->GetDimensions());
  text << "Padding " << filter->GetPadding() << "\nSignMethod " << filter->GetSignMethodAsString()
       << "\nEngine " << filter->GetEngineAsString() << "\nGenerateClosestPoint "
       << filter->GetGenerateClosestPoint() << "\nGenerateClosestCell "
       << filter->GetGenerateClosestCell() << "\nGenerateClosestFeature "
       << filter->GetGenerateClosestFeature() << "\nGenerateClosestSite "
       << filter->GetGenerateClosestSite() << '\n';
  return text.str();
}

//------------------------------------------------------------------------------
std::string TextOf(const medial::Grid& grid)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "a grid";
  for (int axis = 0; axis < 3; ++axis)
  {
    text << (axis > 0 ? " x " : " of ") << grid.dimensions[axis] << " points from "
         << grid.origin[axis] << " at " << grid.spacing[axis];
  }
  return text.str();
}

} // namespace

vtkStandardNewMacro(vtkMeshDistanceField);

//------------------------------------------------------------------------------
vtkMeshDistanceField::vtkMeshDistanceField()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkMeshDistanceField::~vtkMeshDistanceField() = default;

//------------------------------------------------------------------------------
vtkImageData* vtkMeshDistanceField::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
void vtkMeshDistanceField::SetController(vtkMultiProcessController* controller)
{
  if (controller != this->Controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkMultiProcessController* vtkMeshDistanceField::GetController()
{
  return this->Controller;
}

//------------------------------------------------------------------------------
void vtkMeshDistanceField::Modified()
{
  this->FillInputPortInformation(0, this->GetInputPortInformation(0));
  this->Superclass::Modified();
}

//------------------------------------------------------------------------------
// The pipeline goes through the blocks of input that is not asked for here.
int vtkMeshDistanceField::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  if (!this->Superclass::FillInputPortInformation(port, info))
  {
    return 0;
  }
  if (this->DistributedInput)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshDistanceField::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshDistanceField::RequestInformation(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  if (!this->DistributedInput)
  {
    return this->RequestImageInformation(inputVector, outputVector, 0);
  }
  return this->Internals->AnnounceImage(outputVector, 0,
    [&]
    {
      if (this->GridMode == EXPLICIT)
      {
        try
        {
          return this->Internals->MakeGrid(medial::Bounds{});
        }
        catch (const medial::Error&)
        {
          return vtkInternals::UnitGrid(); // told where all ranks meet
        }
      }
      vtkMedialRanks ranks(this->Controller);
      return this->Internals->MakeGrid(
        BoundsOf(ranks.Meet(vtkMedialRanks::Stage::Information, OptionsOf(this),
          [&]
          {
            if (!vtkUpdateInput(this, ranks.rank(), ranks.size()))
            {
              throw medial::Error(medial::ErrorCode::InvalidInput, "there is no input");
            }
            return vtkSurfacePiece(vtkDataObject::GetData(inputVector[0])).Facts();
          })));
    });
}

//------------------------------------------------------------------------------
int vtkMeshDistanceField::RequestUpdateExtent(vtkInformation* request,
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
int vtkMeshDistanceField::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  const bool done = this->Internals->Try(
    [&]
    {
      vtkInternals::Begin(outputVector);
      if (this->DistributedInput)
      {
        this->ComputeOfPieces(inputVector, outputVector);
      }
      else
      {
        this->ComputeOfWhole(inputVector, outputVector);
      }
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMeshDistanceField::ComputeOfWhole(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const medial::Extent extent =
    vtkMeshConversion::ToExtent(outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  if (extent.empty())
  {
    return;
  }
  vtkProgressBridge progress(this);
  const medial::DistanceFieldOptions options = this->Internals->MakeOptions(progress);
  this->Internals->UpdateMesh(vtkPolyData::GetData(inputVector[0]), options.execution);
  const medial::Grid grid = vtkInternals::AnnouncedGrid(outInfo);

  const medial::FieldArrays arrays =
    vtkMeshConversion::AllocateField(output, grid, extent, this->Internals->MakeSelection());
  const medial::RunStatistics statistics = medial::computeDistanceField(this->Internals->Mesh,
    this->Internals->Connectivity, grid, extent, arrays, options);
  this->Internals->Record(grid, statistics, output);
  vtkWarnOnce(this, statistics.note);
}

//------------------------------------------------------------------------------
// A rank without grid points serves the others.
void vtkMeshDistanceField::ComputeOfPieces(vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const medial::Extent extent =
    vtkMeshConversion::ToExtent(outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  const medial::Grid grid = vtkInternals::AnnouncedGrid(outInfo);
  vtkProgressBridge progress(this);
  medial::DistanceFieldOptions options;
  medial::FieldArrays arrays;
  vtkSurfacePiece piece;
  vtkMedialRanks ranks(this->Controller);
  const std::vector<vtkPieceFacts> facts = ranks.Meet(vtkMedialRanks::Stage::Data,
    OptionsOf(this) + TextOf(grid),
    [&]
    {
      if (this->GridMode == EXPLICIT)
      {
        this->Internals->MakeGrid(medial::Bounds{}); // throws what was not told before
      }
      options = this->Internals->MakeOptions(progress);
      piece = vtkSurfacePiece(vtkDataObject::GetData(inputVector[0]));
      if (!extent.empty())
      {
        arrays =
          vtkMeshConversion::AllocateField(output, grid, extent, this->Internals->MakeSelection());
      }
      return piece.Facts();
    });
  ExtentSink sink(extent, arrays);
  medial::RankCounts counts;
  const medial::RunStatistics statistics = medial::computeDistanceField(ranks,
    piece.Numbered(ranks, facts), grid, extent, sink, options, &counts);
  if (!extent.empty())
  {
    this->Internals->Record(grid, statistics, output, false);
    vtkMedialFigures figures(output);
    figures.AddCount("OwnTriangles", counts.ownTriangles);
    figures.AddCount("HeldTriangles", counts.heldTriangles);
    figures.AddCount("BytesSent", counts.bytesSent);
  }
}

//------------------------------------------------------------------------------
void vtkMeshDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DistributedInput: " << (this->DistributedInput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
