#include "vtkMeshConversion.h"

#include "medial/memory.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
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
#include <cstdint>
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
void vtkMeshConversion::SetGlobalIds(const char* name, const std::vector<std::int64_t>& ids,
  vtkDataSetAttributes* attributes)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  attributes->SetGlobalIds(array);
}

//------------------------------------------------------------------------------
void vtkMeshConversion::AddValues(vtkDataSetAttributes* output, const char* name,
  const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  output->AddArray(array);
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
