#include "vtkMedialReconstruction.h"

#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDistributedInput.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkMarchingCubesTriangleCases.h"
#include "vtkMedialCells.h"
#include "vtkMedialExecution.h"
#include "vtkMedialModelConversion.h"
#include "vtkMedialProgress.h"
#include "vtkMedialRanks.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSurfaceBlocks.h"

#include "medial/memory.h"
#include "medial/ranks.h"
#include "medial/reconstruction.h"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMedialReconstruction);

namespace
{

/// The field's share of the work; the rest is contouring.
constexpr double FieldShare = 0.9;

/// The field, VTK's copy of it, and what the contour filter notes about each edge.
constexpr int BytesPerGridPoint = 2 * sizeof(float) + 1;

//------------------------------------------------------------------------------
// The contour filter makes points in single precision, which suffices only near the origin.
void MoveTo(const medial::Point3& origin, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    points->SetPoint(i, origin[0] + x[0], origin[1] + x[1], origin[2] + x[2]);
  }
  surface->SetPoints(points);
}

// How many triangles a cell of an image has, by which of its corners are inside.
std::array<int, 256> TrianglesOfCases()
{
  std::array<int, 256> counts{};
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const vtkMarchingCubesTriangleCases& triangles = vtkMarchingCubesTriangleCases::GetCases()[i];
    while (triangles.edges[static_cast<std::size_t>(3 * counts[i])] >= 0)
    {
      ++counts[i];
    }
  }
  return counts;
}

//------------------------------------------------------------------------------
// Whether triangles are those of cells that an extent has, one for each triangle of a contour of an
// image, which come cell after cell, x fastest.
std::vector<char> AreOfCells(const medial::Extent& own, vtkImageData* image)
{
  static const std::array<int, 256> counts = TrianglesOfCases();
  // As vtkMarchingCubesTriangleCases numbers the corners of a cell.
  constexpr std::array<std::array<int, 3>, 8> Corners{ { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 },
    { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } } };
  const float* values =
    vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars())->GetPointer(0);
  vtkIdType steps[3];
  image->GetIncrements(steps);
  int extent[6];
  image->GetExtent(extent);
  std::vector<char> areOwn;
  for (int k = extent[4]; k < extent[5]; ++k)
  {
    for (int j = extent[2]; j < extent[3]; ++j)
    {
      const float* cell = values + (k - extent[4]) * steps[2] + (j - extent[2]) * steps[1];
      const bool ofRow = own.min[1] <= j && j < own.max[1] && own.min[2] <= k && k < own.max[2];
      for (int i = extent[0]; i < extent[1]; ++i, ++cell)
      {
        std::size_t inside = 0;
        for (std::size_t corner = 0; corner < Corners.size(); ++corner)
        {
          const auto& [x, y, z] = Corners[corner];
          const float value = cell[x + y * steps[1] + z * steps[2]];
          inside |= static_cast<std::size_t>(value >= 0.0F) << corner;
        }
        const bool isOwn = ofRow && own.min[0] <= i && i < own.max[0];
        areOwn.insert(areOwn.end(), static_cast<std::size_t>(counts[inside]), isOwn ? 1 : 0);
      }
    }
  }
  return areOwn;
}

//------------------------------------------------------------------------------
// Leaves out triangles, and points that no other triangle has.
void Keep(const std::vector<char>& areKept, vtkPolyData* surface)
{
  if (static_cast<vtkIdType>(areKept.size()) != surface->GetNumberOfCells())
  {
    throw std::logic_error("the triangles of vtkFlyingEdges3D do not come cell after cell");
  }
  vtkPointData* attributes = surface->GetPointData();
  vtkNew<vtkPolyData> kept;
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> triangles;
  kept->GetPointData()->CopyAllOn();
  kept->GetPointData()->CopyAllocate(attributes);
  std::vector<vtkIdType> numbers(static_cast<std::size_t>(surface->GetNumberOfPoints()), -1);
  std::size_t cell = 0;
  vtkForEachCell(surface->GetPolys(),
    [&](const vtkIdType* ids, vtkIdType size)
    {
      if (!areKept[cell++])
      {
        return;
      }
      triangles->InsertNextCell(static_cast<int>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        vtkIdType& number = numbers[static_cast<std::size_t>(ids[i])];
        if (number < 0)
        {
          number = points->InsertNextPoint(surface->GetPoint(ids[i]));
          kept->GetPointData()->CopyData(attributes, ids[i], number);
        }
        triangles->InsertCellPoint(number);
      }
    });
  kept->SetPoints(points);
  kept->SetPolys(triangles);
  surface->ShallowCopy(kept);
}

//------------------------------------------------------------------------------
// The triangles of the cells in a part of a grid.
//
// field is that of an extent, which has a layer of points around the part, where there are some:
// normals depend on them.
void Contour(const medial::Grid& grid, const medial::Extent& extent, const medial::Extent& part,
  const std::vector<float>& field, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Depth");
  values->SetNumberOfValues(static_cast<vtkIdType>(field.size()));
  // The contour filter takes high values for the inside. Negated, triangles and normals face
  // outwards.
  std::transform(field.begin(), field.end(), values->GetPointer(0), std::negate<float>());
  vtkNew<vtkImageData> image;
  image->SetSpacing(grid.spacing.data());
  image->SetExtent(extent.min[0], extent.max[0], extent.min[1], extent.max[1], extent.min[2],
    extent.max[2]);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  contour->Update();
  output->ShallowCopy(contour->GetOutput());
  if (!part.contains(extent))
  {
    Keep(AreOfCells(part, image), output);
  }
  MoveTo(grid.origin, output);
}

//------------------------------------------------------------------------------
// The piece of an axis that a rank has, which may be nothing.
medial::MedialModel ToPiece(vtkDataObject* input)
{
  vtkSmartPointer<vtkPolyData> axis = vtkPolyData::SafeDownCast(input);
  if (!axis)
  {
    const vtkSurfaceBlocks blocks(input);
    axis = vtkSmartPointer<vtkPolyData>::New();
    blocks.ToPolyData(std::vector<char>(static_cast<std::size_t>(blocks.GetNumberOfCells())), axis);
  }
  return axis->GetNumberOfPoints() == 0 ? medial::MedialModel{}
                                        : vtkMedialModelConversion::ToMedialModel(axis);
}

//------------------------------------------------------------------------------
// The parameters that must be the same on all ranks, a line with a name and a value each.
std::string Describe(vtkMedialReconstruction* filter)
{
  std::ostringstream text;
  text << "Resolution " << filter->GetResolution() << "\nInterpolate " << filter->GetInterpolate()
       << '\n';
  return text.str();
}

//------------------------------------------------------------------------------
// The part of a grid whose cells a rank contours, with the points on its cuts. Empty where there is
// no cell.
medial::Extent PartOf(const medial::Grid& grid, const vtkMedialRanks& ranks)
{
  const auto rank = static_cast<std::size_t>(ranks.rank());
  const medial::Extent part =
    medial::touchingExtent(grid, medial::partsOfGrid(grid, ranks.size())[rank]);
  const bool hasCells = part.size(0) > 1 && part.size(1) > 1 && part.size(2) > 1;
  return hasCells ? part : medial::Extent{};
}

//------------------------------------------------------------------------------
// A part with the layer of points around it that the grid has.
medial::Extent WithLayer(const medial::Extent& part, const medial::Grid& grid)
{
  medial::Extent extent = part;
  for (std::size_t axis = 0; axis < 3 && !part.empty(); ++axis)
  {
    extent.min[axis] = std::max(part.min[axis] - 1, 0);
    extent.max[axis] = std::min(part.max[axis] + 1, grid.dimensions[axis] - 1);
  }
  return extent;
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialReconstruction::vtkMedialReconstruction()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkMedialReconstruction::~vtkMedialReconstruction() = default;

//------------------------------------------------------------------------------
vtkCxxDistributedInputMacro(vtkMedialReconstruction);

//------------------------------------------------------------------------------
int vtkMedialReconstruction::RequestData(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->DistributedInput)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const bool done = vtkRunGuarded(this, this->ErrorCode,
    [&]
    {
      this->ExecutePieces(vtkDataObject::GetData(inputVector[0]),
        vtkPolyData::GetData(outputVector));
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialReconstruction::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkProgressBridge bridge(this);
  vtkProgressPart progress(bridge, 0.0, FieldShare);
  const medial::MedialModel model = vtkMedialModelConversion::ToMedialModel(inputs[0]);
  const medial::Grid grid = medial::makeGrid(medial::modelBounds(model), this->Resolution);
  medial::requireMemory(grid.pointCount(), BytesPerGridPoint);
  const std::vector<float> field =
    medial::computeReconstruction(model, grid, { this->Interpolate != 0, { 0, &progress } });
  bridge.ReportOrStop(FieldShare, "contour");
  const medial::Extent whole = grid.wholeExtent();
  Contour(grid, whole, whole, field, outputs[0]);
}

//------------------------------------------------------------------------------
// Each rank contours its part of the grid that the whole axis has.
void vtkMedialReconstruction::ExecutePieces(vtkDataObject* input, vtkPolyData* output)
{
  vtkProgressBridge bridge(this);
  vtkProgressPart progress(bridge, 0.0, FieldShare);
  medial::MedialModel piece;
  vtkMedialRanks ranks(this->Controller);
  ranks.Meet(vtkMedialRanks::Stage::Data, Describe(this),
    [&]
    {
      piece = ToPiece(input);
      return vtkPieceFacts{};
    });
  medial::agree(ranks,
    [&]
    {
      const medial::Grid grid =
        medial::makeGrid(medial::modelBounds(ranks, piece), this->Resolution);
      const medial::Extent part = PartOf(grid, ranks);
      const medial::Extent extent = WithLayer(part, grid);
      medial::requireMemory(extent.pointCount(), BytesPerGridPoint);
      const std::vector<float> field = medial::computeReconstruction(ranks, piece, grid, extent,
        { this->Interpolate != 0, { 0, &progress } });
      bridge.ReportOrStop(FieldShare, "contour");
      if (!extent.empty())
      {
        Contour(grid, extent, part, field, output);
      }
    });
}

//------------------------------------------------------------------------------
void vtkMedialReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Interpolate: " << (this->Interpolate ? "On" : "Off") << "\n";
  os << indent << "DistributedInput: " << (this->DistributedInput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
