#include "vtkMeshDistanceField.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialProgress.h"
#include "vtkMedialRanks.h"
#include "vtkMedialRequests.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkSurfacePiece.h"

#include "medial/compute_distance_field.h"
#include "medial/error.h"

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
      return this->Internals->MakeGrid(vtkMedialRanks::BoundsOf(
        ranks.Meet(vtkMedialRanks::Stage::Information, this->Internals->DescribeOptions(),
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
    this->Internals->DescribeOptions() + TextOf(grid),
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
  medial::agree(ranks,
    [&]
    {
      ExtentSink sink(extent, arrays);
      medial::RankCounts counts;
      const medial::RunStatistics statistics = medial::computeDistanceField(ranks,
        piece.Numbered(ranks, facts), grid, extent, sink, options, &counts);
      if (!extent.empty())
      {
        this->Internals->Record(grid, statistics, output, false);
        vtkMedialFigures(output).AddRankCounts(counts);
      }
    });
}

//------------------------------------------------------------------------------
void vtkMeshDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
