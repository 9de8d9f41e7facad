#include "vtkThicknessConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMeshConversion.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <unordered_map>

namespace
{

//------------------------------------------------------------------------------
// Sets the points of a divided mesh and their data.
void InterpolatePoints(vtkPolyData* input, const medial::Subdivision& fine, vtkPolyData* output)
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
}

} // namespace

//------------------------------------------------------------------------------
void vtkThicknessConversion::AddThickness(const medial::Thickness& thickness,
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
  vtkMeshConversion::AddValues(surface->GetPointData(), "Thickness", values);
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
  vtkMeshConversion::AddValues(surface->GetCellData(), "Thickness", cells);
}

//------------------------------------------------------------------------------
void vtkThicknessConversion::AddRegions(const std::vector<medial::ThicknessRegion>& regions,
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
void vtkThicknessConversion::Subdivide(vtkPolyData* input, const medial::Subdivision& fine,
  vtkPolyData* output)
{
  const medial::TriangleMesh& mesh = fine.mesh;
  InterpolatePoints(input, fine, output);
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
void vtkThicknessConversion::Subdivide(vtkPolyData* surface, const medial::TriangleMesh& coarse,
  const std::vector<std::int64_t>& numbers, medial::PieceSubdivision& fine, vtkPolyData* output)
{
  std::unordered_map<std::int64_t, std::int64_t> cellOf;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    cellOf[numbers[i]] = coarse.triangleCells[i];
  }
  medial::TriangleMesh& mesh = fine.piece.mesh;
  std::vector<std::int64_t> inputCells = mesh.vertexCells;
  inputCells.insert(inputCells.end(), mesh.segmentCells.begin(), mesh.segmentCells.end());
  inputCells.insert(inputCells.end(), mesh.triangleCells.begin(), mesh.triangleCells.end());
  for (std::int64_t& cell : mesh.triangleCells)
  {
    cell = cellOf[cell];
  }
  mesh.segmentCells = coarse.segmentCells;
  mesh.vertexCells = coarse.vertexCells;
  mesh.pointOfInput = coarse.pointOfInput;
  // Those of the piece do not name what is new.
  surface->GetPointData()->RemoveArray("vtkGlobalPointIds");
  surface->GetCellData()->RemoveArray("vtkGlobalCellIds");
  Subdivide(surface, { mesh, fine.parents }, output);
  output->GetFieldData()->PassData(surface->GetFieldData());
  vtkMeshConversion::SetGlobalIds("vtkGlobalPointIds", fine.piece.pointOrder,
    output->GetPointData());
  vtkDataArray* cells = output->GetCellData()->GetArray("InputCell");
  for (std::size_t i = 0; i < inputCells.size(); ++i)
  {
    cells->SetComponent(static_cast<vtkIdType>(i), 0, static_cast<double>(inputCells[i]));
  }
}

//------------------------------------------------------------------------------
void vtkThicknessConversion::ToPolyData(const std::vector<medial::ThicknessRegion>& regions,
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
  vtkMeshConversion::AddValues(output->GetPointData(), "Thickness", values);
  output->GetCellData()->AddArray(numbers);
  vtkMeshConversion::AddValues(output->GetCellData(), "Thickness", cellValues);
  output->GetCellData()->AddArray(inputCells);
  output->GetPointData()->SetActiveScalars("Thickness");
}
