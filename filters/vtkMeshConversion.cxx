#include "vtkMeshConversion.h"

#include "medial/memory.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace
{

// The library writes cell ids as std::int64_t straight into a vtkIdTypeArray.
static_assert(sizeof(vtkIdType) == sizeof(std::int64_t), "VTK must be built with 64-bit ids");

//------------------------------------------------------------------------------
void AppendPoints(vtkPolyData* input, std::vector<medial::Point3>& points)
{
  points.resize(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
}

//------------------------------------------------------------------------------
// Appends the cells of one of the four cell arrays; the first of them has the id firstId. Returns
// the id that follows the last.
vtkIdType AppendCells(vtkCellArray* cells, vtkIdType firstId, medial::CellList& list)
{
  const vtkIdType count = cells->GetNumberOfCells();
  list.ids.reserve(static_cast<std::size_t>(count));
  list.offsets.reserve(static_cast<std::size_t>(count) + 1);
  list.connectivity.reserve(static_cast<std::size_t>(cells->GetNumberOfConnectivityIds()));
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    iterator->GetCurrentCell(size, ids);
    if (size > 0)
    {
      list.connectivity.insert(list.connectivity.end(), ids, ids + size);
      list.offsets.push_back(static_cast<std::int64_t>(list.connectivity.size()));
      list.ids.push_back(firstId + iterator->GetCurrentCellId());
    }
  }
  return firstId + count;
}

//------------------------------------------------------------------------------
std::size_t BytesPerPoint(const vtkMeshConversion::ArraySelection& selection)
{
  return sizeof(float) + (selection.ClosestPoint ? 3 * sizeof(float) : 0) +
    (selection.ClosestCell ? sizeof(vtkIdType) : 0) + (selection.ClosestFeature ? 1 : 0) +
    (selection.ClosestSite ? sizeof(int) : 0);
}

//------------------------------------------------------------------------------
template <typename ArrayType>
ArrayType* AddArray(vtkDataSet* data, const char* name, int components)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

//------------------------------------------------------------------------------
void AddValues(vtkDataSetAttributes* output, const char* name, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->AddArray(array);
}

//------------------------------------------------------------------------------
void AddVectors(vtkPolyData* output, const char* name,
  const std::vector<std::array<float, 3>>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), values[i].data());
  }
  output->GetPointData()->AddArray(array);
}

//------------------------------------------------------------------------------
void AddVectors(const std::vector<medial::Point3>& values, const char* name, vtkDataSet* output)
{
  double* target = AddArray<vtkDoubleArray>(output, name, 3)->GetPointer(0);
  for (const medial::Point3& value : values)
  {
    target = std::copy(value.begin(), value.end(), target);
  }
}

//------------------------------------------------------------------------------
template <std::size_t Size>
void InsertCells(const std::vector<std::array<std::int64_t, Size>>& from, vtkCellArray* to)
{
  for (const auto& cell : from)
  {
    std::array<vtkIdType, Size> ids;
    std::copy(cell.begin(), cell.end(), ids.begin());
    to->InsertNextCell(static_cast<vtkIdType>(Size), ids.data());
  }
}

//------------------------------------------------------------------------------
void SetCells(const medial::MedialAxis& axis, vtkPolyData* output)
{
  vtkNew<vtkCellArray> verts;
  for (const std::int64_t vertex : axis.vertices)
  {
    const vtkIdType id = vertex;
    verts->InsertNextCell(1, &id);
  }
  vtkNew<vtkCellArray> lines;
  InsertCells(axis.lines, lines);
  vtkNew<vtkCellArray> polys;
  const std::size_t cells = axis.quads.size() + axis.triangles.size();
  polys->AllocateExact(static_cast<vtkIdType>(cells),
    static_cast<vtkIdType>(4 * axis.quads.size() + 3 * axis.triangles.size()));
  InsertCells(axis.quads, polys);
  InsertCells(axis.triangles, polys);
  output->SetVerts(verts);
  output->SetLines(lines);
  output->SetPolys(polys);
}

//------------------------------------------------------------------------------
// Sets cells and their arrays. VTK counts vertices before lines, so a branch's id is an array.
void SetBranches(const medial::Skeleton& skeleton, vtkPolyData* output)
{
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> ids;
  ids->SetName("BranchId");
  vtkNew<vtkUnsignedCharArray> kinds;
  kinds->SetName("Kind");
  const char* const names[] = { "Length", "MeanRadius", "MinRadius", "MaxRadius" };
  std::array<vtkSmartPointer<vtkDoubleArray>, 4> values;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    values[i] = vtkSmartPointer<vtkDoubleArray>::New();
    values[i]->SetName(names[i]);
  }
  for (const bool single : { true, false })
  {
    for (std::size_t b = 0; b < skeleton.branches.size(); ++b)
    {
      const medial::SkeletonBranch& branch = skeleton.branches[b];
      if ((branch.points.size() == 1) != single)
      {
        continue;
      }
      vtkCellArray* cells = single ? verts : lines;
      cells->InsertNextCell(static_cast<int>(branch.points.size()));
      for (const std::int64_t point : branch.points)
      {
        cells->InsertCellPoint(point);
      }
      ids->InsertNextValue(static_cast<int>(b));
      kinds->InsertNextValue(static_cast<unsigned char>(branch.kind));
      const double measured[] = { branch.length, branch.meanRadius, branch.minRadius,
        branch.maxRadius };
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i]->InsertNextValue(measured[i]);
      }
    }
  }
  output->SetVerts(verts);
  output->SetLines(lines);
  output->GetCellData()->AddArray(ids);
  output->GetCellData()->AddArray(kinds);
  for (const auto& array : values)
  {
    output->GetCellData()->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void SetGlobalIds(const char* name, const std::vector<std::int64_t>& ids,
  vtkDataSetAttributes* attributes)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  attributes->SetGlobalIds(array);
}

} // namespace

//------------------------------------------------------------------------------
medial::MeshInput vtkMeshConversion::ToMeshInput(vtkPolyData* input)
{
  medial::MeshInput mesh;
  AppendPoints(input, mesh.points);
  vtkIdType nextId = AppendCells(input->GetVerts(), 0, mesh.verts);
  nextId = AppendCells(input->GetLines(), nextId, mesh.lines);
  nextId = AppendCells(input->GetPolys(), nextId, mesh.polygons);
  AppendCells(input->GetStrips(), nextId, mesh.strips);
  return mesh;
}

//------------------------------------------------------------------------------
medial::FieldArrays vtkMeshConversion::AllocateField(vtkImageData* output, const medial::Grid& grid,
  const medial::Extent& extent, const ArraySelection& selection)
{
  medial::requireMemory(extent.pointCount(), BytesPerPoint(selection));
  int vtkExtent[6];
  ToVTKExtent(extent, vtkExtent);
  output->SetOrigin(grid.origin.data());
  output->SetSpacing(grid.spacing.data());
  output->SetExtent(vtkExtent);

  medial::FieldArrays arrays;
  arrays.distance = AddArray<vtkFloatArray>(output, "Distance", 1)->GetPointer(0);
  output->GetPointData()->SetActiveScalars("Distance");
  if (selection.ClosestPoint)
  {
    arrays.closestPoint = AddArray<vtkFloatArray>(output, "ClosestPoint", 3)->GetPointer(0);
  }
  if (selection.ClosestCell)
  {
    arrays.closestCell = reinterpret_cast<std::int64_t*>(
      AddArray<vtkIdTypeArray>(output, "ClosestCell", 1)->GetPointer(0));
  }
  if (selection.ClosestFeature)
  {
    arrays.closestFeature =
      AddArray<vtkUnsignedCharArray>(output, "ClosestFeature", 1)->GetPointer(0);
  }
  if (selection.ClosestSite)
  {
    arrays.closestSite = AddArray<vtkIntArray>(output, "ClosestSite", 1)->GetPointer(0);
  }
  return arrays;
}

//------------------------------------------------------------------------------
void vtkMeshConversion::ToPolyData(const medial::MedialAxis& axis, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(axis.points.size()));
  for (std::size_t i = 0; i < axis.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), axis.points[i].data());
  }
  output->SetPoints(points);
  SetCells(axis, output);
  AddValues(output->GetPointData(), "Radius", axis.radius);
  AddValues(output->GetPointData(), "SeparationAngle", axis.separationAngle);
  AddValues(output->GetPointData(), "Lambda", axis.lambda);
  AddVectors(output, "ClosestPointA", axis.closestPointA);
  AddVectors(output, "ClosestPointB", axis.closestPointB);
  if (axis.feature.size() == axis.points.size())
  {
    vtkNew<vtkUnsignedCharArray> features;
    features->SetName("AxisFeature");
    features->SetNumberOfValues(static_cast<vtkIdType>(axis.feature.size()));
    std::transform(axis.feature.begin(), axis.feature.end(), features->GetPointer(0),
      [](medial::AxisFeature feature) { return static_cast<unsigned char>(feature); });
    output->GetPointData()->AddArray(features);
  }
  output->GetPointData()->SetActiveScalars("Radius");
}

//------------------------------------------------------------------------------
void vtkMeshConversion::ToPolyData(const medial::AxisPiece& piece, vtkPolyData* output)
{
  ToPolyData(piece.axis, output);
  SetGlobalIds("vtkGlobalPointIds", piece.globalPointIds, output->GetPointData());
  SetGlobalIds("vtkGlobalCellIds", piece.globalCellIds, output->GetCellData());
}

//------------------------------------------------------------------------------
void vtkMeshConversion::ToPolyData(const medial::Skeleton& skeleton, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(skeleton.points.size()));
  for (std::size_t i = 0; i < skeleton.points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), skeleton.points[i].data());
  }
  output->SetPoints(points);
  std::copy(skeleton.radius.begin(), skeleton.radius.end(),
    AddArray<vtkDoubleArray>(output, "Radius", 1)->GetPointer(0));
  std::copy(skeleton.arcLength.begin(), skeleton.arcLength.end(),
    AddArray<vtkDoubleArray>(output, "ArcLength", 1)->GetPointer(0));
  std::copy(skeleton.degree.begin(), skeleton.degree.end(),
    AddArray<vtkIntArray>(output, "Degree", 1)->GetPointer(0));
  AddVectors(skeleton.tangent, "Tangent", output);
  output->GetPointData()->SetActiveScalars("Radius");
  SetBranches(skeleton, output);
}

//------------------------------------------------------------------------------
void vtkMeshConversion::AddThickness(const medial::Thickness& thickness,
  const medial::TriangleMesh& mesh, vtkPolyData* surface, bool divided)
{
  constexpr float none = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> values;
  if (divided)
  {
    values = thickness.values;
  }
  else
  {
    values.reserve(mesh.pointOfInput.size());
    for (const int point : mesh.pointOfInput)
    {
      values.push_back(point >= 0 ? thickness.values[point] : none);
    }
  }
  AddValues(surface->GetPointData(), "Thickness", values);
  surface->GetPointData()->SetActiveScalars("Thickness");
  if (thickness.triangleValues.empty())
  {
    return;
  }
  std::vector<float> cells(static_cast<std::size_t>(surface->GetNumberOfCells()), none);
  const std::size_t first = mesh.vertices.size() + mesh.segments.size();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    float& value = cells[divided ? first + i : static_cast<std::size_t>(mesh.triangleCells[i])];
    value = std::fmin(value, thickness.triangleValues[i]);
  }
  AddValues(surface->GetCellData(), "Thickness", cells);
}

//------------------------------------------------------------------------------
void vtkMeshConversion::AddRegions(const std::vector<medial::ThicknessRegion>& regions,
  const medial::TriangleMesh& mesh, vtkPolyData* surface, bool divided)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Region");
  numbers->SetNumberOfValues(surface->GetNumberOfCells());
  numbers->FillValue(0);
  const auto first = static_cast<std::int64_t>(mesh.vertices.size() + mesh.segments.size());
  const auto named = [](auto& array, const char* name, int components)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
  };
  vtkNew<vtkUnsignedCharArray> thin;
  named(thin, "RegionThin", 1);
  vtkNew<vtkDoubleArray> value;
  named(value, "RegionValue", 1);
  vtkNew<vtkDoubleArray> place;
  named(place, "RegionPlace", 3);
  vtkNew<vtkDoubleArray> area;
  named(area, "RegionArea", 1);
  for (std::size_t i = regions.size(); i-- > 0;) // of several regions in a cell the first stays
  {
    for (const int triangle : regions[i].triangles)
    {
      numbers->SetValue(divided ? first + triangle : mesh.triangleCells[triangle],
        static_cast<int>(i) + 1);
    }
  }
  for (const medial::ThicknessRegion& region : regions)
  {
    thin->InsertNextValue(region.thin ? 1 : 0);
    value->InsertNextValue(region.value);
    place->InsertNextTuple(region.place.data());
    area->InsertNextValue(region.area);
  }
  surface->GetCellData()->AddArray(numbers);
  for (vtkDataArray* array : std::initializer_list<vtkDataArray*>{ thin, value, place, area })
  {
    surface->GetFieldData()->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void vtkMeshConversion::Subdivide(vtkPolyData* input, const medial::Subdivision& fine,
  vtkPolyData* output)
{
  const medial::TriangleMesh& mesh = fine.mesh;
  const auto count = static_cast<vtkIdType>(mesh.points.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  vtkPointData* pointData = output->GetPointData();
  pointData->InterpolateAllocate(input->GetPointData(), count);
  for (std::size_t i = 0; i < mesh.pointOfInput.size(); ++i)
  {
    if (mesh.pointOfInput[i] >= 0)
    {
      pointData->CopyData(input->GetPointData(), static_cast<vtkIdType>(i), mesh.pointOfInput[i]);
    }
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, mesh.points[i].data());
  }
  for (std::size_t i = 0; i < fine.parents.size(); ++i)
  {
    pointData->InterpolateEdge(pointData, static_cast<vtkIdType>(fine.originalPoints() + i),
      fine.parents[i][0], fine.parents[i][1], 0.5);
  }
  output->SetPoints(points);
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllocate(input->GetCellData());
  vtkIdType cell = 0;
  const auto insert = [&](const auto& cells, const std::vector<std::int64_t>& ids)
  {
    vtkNew<vtkCellArray> array;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      array->InsertNextCell(static_cast<int>(cells[i].size()));
      for (const int point : cells[i])
      {
        array->InsertCellPoint(point);
      }
      cellData->CopyData(input->GetCellData(), ids[i], cell++);
    }
    return array;
  };
  std::vector<std::array<int, 1>> vertices;
  for (const int point : mesh.vertices)
  {
    vertices.push_back({ point });
  }
  output->SetVerts(insert(vertices, mesh.vertexCells));
  output->SetLines(insert(mesh.segments, mesh.segmentCells));
  output->SetPolys(insert(mesh.triangles, mesh.triangleCells));
  vtkNew<vtkIdTypeArray> inputCells;
  inputCells->SetName("InputCell");
  for (const auto* ids : { &mesh.vertexCells, &mesh.segmentCells, &mesh.triangleCells })
  {
    for (const std::int64_t id : *ids)
    {
      inputCells->InsertNextValue(id);
    }
  }
  cellData->AddArray(inputCells);
}

//------------------------------------------------------------------------------
void vtkMeshConversion::ToPolyData(const std::vector<medial::ThicknessRegion>& regions,
  const medial::TriangleMesh& mesh, const medial::Thickness& thickness, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Region");
  vtkNew<vtkIdTypeArray> inputCells;
  inputCells->SetName("InputCell");
  std::vector<float> values;
  std::vector<float> cellValues;
  std::vector<vtkIdType> ids(mesh.points.size(), -1);
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    for (const int triangle : regions[region].triangles)
    {
      cells->InsertNextCell(3);
      for (const int corner : mesh.triangles[triangle])
      {
        if (ids[corner] < 0)
        {
          ids[corner] = points->InsertNextPoint(mesh.points[corner].data());
          values.push_back(thickness.values[corner]);
        }
        cells->InsertCellPoint(ids[corner]);
      }
      numbers->InsertNextValue(static_cast<int>(region) + 1);
      inputCells->InsertNextValue(mesh.triangleCells[triangle]);
      cellValues.push_back(thickness.triangleValues[triangle]);
    }
  }
  output->SetPoints(points);
  output->SetPolys(cells);
  AddValues(output->GetPointData(), "Thickness", values);
  output->GetCellData()->AddArray(numbers);
  AddValues(output->GetCellData(), "Thickness", cellValues);
  output->GetCellData()->AddArray(inputCells);
  output->GetPointData()->SetActiveScalars("Thickness");
}

//------------------------------------------------------------------------------
void vtkMeshConversion::AddDistances(const medial::PointDistances& distances, vtkDataSet* output)
{
  std::copy(distances.distance.begin(), distances.distance.end(),
    AddArray<vtkDoubleArray>(output, "Distance", 1)->GetPointer(0));
  output->GetPointData()->SetActiveScalars("Distance");
  AddVectors(distances.closestPoint, "ClosestPoint", output);
  std::copy(distances.closestCell.begin(), distances.closestCell.end(),
    AddArray<vtkIdTypeArray>(output, "ClosestCell", 1)->GetPointer(0));
  std::transform(distances.closestFeature.begin(), distances.closestFeature.end(),
    AddArray<vtkUnsignedCharArray>(output, "ClosestFeature", 1)->GetPointer(0),
    [](medial::Feature feature) { return static_cast<unsigned char>(feature); });
  AddVectors(distances.direction, "Direction", output);
}

//------------------------------------------------------------------------------
medial::Extent vtkMeshConversion::ToExtent(const int vtkExtent[6])
{
  return { { vtkExtent[0], vtkExtent[2], vtkExtent[4] },
    { vtkExtent[1], vtkExtent[3], vtkExtent[5] } };
}

//------------------------------------------------------------------------------
void vtkMeshConversion::ToVTKExtent(const medial::Extent& extent, int vtkExtent[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkExtent[2 * axis] = extent.min[axis];
    vtkExtent[2 * axis + 1] = extent.max[axis];
  }
}
