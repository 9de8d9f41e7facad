#include "vtkSurfaceBlocks.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include "medial/error.h"

#include <algorithm>
#include <string>
#include <utility>

namespace
{

using Numbers = std::vector<std::int64_t>;
using OutputNumbers = vtkSurfaceBlocks::OutputNumbers;

//------------------------------------------------------------------------------
[[noreturn]] void Refuse(const std::string& message)
{
  throw medial::Error(medial::ErrorCode::InvalidInput, message);
}

//------------------------------------------------------------------------------
void AddBlock(vtkDataObject* block, std::vector<vtkPointSet*>& blocks)
{
  auto* data = vtkPointSet::SafeDownCast(block);
  if (!vtkPolyData::SafeDownCast(data) && !vtkUnstructuredGrid::SafeDownCast(data))
  {
    Refuse(std::string("the input is ") + (block ? block->GetClassName() : "nothing") +
      ", not a vtkPolyData or vtkUnstructuredGrid");
  }
  if (data->GetNumberOfCells() > 0) // those without often have no arrays
  {
    blocks.push_back(data);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkPointSet*> BlocksOf(vtkDataObject* input)
{
  std::vector<vtkPointSet*> blocks;
  auto* composite = vtkCompositeDataSet::SafeDownCast(input);
  if (!composite)
  {
    AddBlock(input, blocks);
    return blocks;
  }
  auto iterator = vtk::TakeSmartPointer(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    AddBlock(iterator->GetCurrentDataObject(), blocks);
  }
  return blocks;
}

//------------------------------------------------------------------------------
// Whoever makes arrays by hand may make them too short.
void RequireOneForEach(vtkDataArray* array, vtkIdType count, const char* name)
{
  if (array->GetNumberOfTuples() != count)
  {
    Refuse(std::string(name) + " has " + std::to_string(array->GetNumberOfTuples()) +
      " values, and there are " + std::to_string(count) + " points or cells to have one");
  }
}

//------------------------------------------------------------------------------
// The global ids of all blocks, or none if some has none. Some filters keep such ids without
// marking them, under their usual name.
Numbers GlobalIds(const std::vector<vtkPointSet*>& blocks, int association, const char* name)
{
  Numbers numbers;
  for (vtkPointSet* block : blocks)
  {
    vtkDataSetAttributes* attributes = block->GetAttributes(association);
    vtkDataArray* ids = attributes->GetGlobalIds();
    ids = ids ? ids : attributes->GetArray(name);
    if (!ids)
    {
      return {};
    }
    RequireOneForEach(ids, block->GetNumberOfElements(association), name);
    for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
    {
      numbers.push_back(ids->GetVariantValue(i).ToTypeInt64());
      if (numbers.back() < 0)
      {
        Refuse("element " + std::to_string(i) + " of " + name + " is " +
          std::to_string(numbers.back()) + ", not a number of 0 or more");
      }
    }
  }
  return numbers;
}

//------------------------------------------------------------------------------
medial::CellList& ListFor(vtkPointSet* block, vtkIdType cell, medial::MeshInput& mesh)
{
  const int type = block->GetCellType(cell);
  switch (type)
  {
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
      return mesh.verts;
    case VTK_LINE:
    case VTK_POLY_LINE:
      return mesh.lines;
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_PIXEL:
    case VTK_POLYGON:
      return mesh.polygons;
    case VTK_TRIANGLE_STRIP:
      return mesh.strips;
    default:
      Refuse("cell " + std::to_string(cell) + " is a " +
        vtkCellTypes::GetClassNameFromTypeId(type) + ", not part of a surface");
  }
}

//------------------------------------------------------------------------------
// firstCell is the number of the block's first cell.
void AppendBlock(vtkPointSet* block, std::int64_t firstCell, medial::MeshInput& mesh)
{
  const auto firstPoint = static_cast<std::int64_t>(mesh.points.size());
  for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
  {
    mesh.points.emplace_back();
    block->GetPoint(point, mesh.points.back().data());
  }
  vtkDataArray* ghosts = block->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
  if (ghosts)
  {
    RequireOneForEach(ghosts, block->GetNumberOfCells(), vtkDataSetAttributes::GhostArrayName());
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < block->GetNumberOfCells(); ++cell)
  {
    block->GetCellPoints(cell, ids);
    if (ids->GetNumberOfIds() == 0 || (ghosts && ghosts->GetComponent(cell, 0) != 0.0))
    {
      continue;
    }
    Numbers corners(ids->begin(), ids->end());
    if (block->GetCellType(cell) == VTK_PIXEL)
    {
      std::swap(corners[2], corners[3]);
    }
    for (std::int64_t& corner : corners)
    {
      corner += firstPoint;
    }
    ListFor(block, cell, mesh).append(corners, firstCell + cell);
  }
}

//------------------------------------------------------------------------------
// isLeftOut tells of each cell of the blocks.
OutputNumbers NumbersOf(const medial::MeshInput& mesh, const std::vector<char>& isLeftOut)
{
  OutputNumbers numbers{ Numbers(mesh.points.size(), -1), Numbers(isLeftOut.size(), -1) };
  std::int64_t next = 0;
  for (const medial::CellList* list : { &mesh.verts, &mesh.lines, &mesh.polygons, &mesh.strips })
  {
    for (std::size_t i = 0; i < list->ids.size(); ++i)
    {
      if (!isLeftOut[list->ids[i]])
      {
        numbers.Cells[list->ids[i]] = next++;
        std::for_each(list->connectivity.begin() + list->offsets[i],
          list->connectivity.begin() + list->offsets[i + 1],
          [&](std::int64_t point) { numbers.Points[point] = 0; });
      }
    }
  }
  next = 0;
  for (std::int64_t& number : numbers.Points)
  {
    number = number < 0 ? number : next++;
  }
  return numbers;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> PointsOf(const std::vector<vtkPointSet*>& blocks,
  const std::vector<medial::Point3>& points, const Numbers& numbers)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  const bool allAreFloats = std::all_of(blocks.begin(), blocks.end(),
    [](vtkPointSet* block) { return block->GetPoints()->GetDataType() == VTK_FLOAT; });
  result->SetDataType(allAreFloats ? VTK_FLOAT : VTK_DOUBLE);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (numbers[i] >= 0)
    {
      result->InsertNextPoint(points[i].data());
    }
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> CellsOf(const medial::CellList& list, const OutputNumbers& numbers)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (std::size_t i = 0; i < list.ids.size(); ++i)
  {
    if (numbers.Cells[list.ids[i]] >= 0)
    {
      cells->InsertNextCell(static_cast<int>(list.offsets[i + 1] - list.offsets[i]));
      for (std::int64_t corner = list.offsets[i]; corner < list.offsets[i + 1]; ++corner)
      {
        cells->InsertCellPoint(numbers.Points[list.connectivity[corner]]);
      }
    }
  }
  return cells;
}

//------------------------------------------------------------------------------
// Passes on the arrays that all blocks have.
void CopyArrays(const std::vector<vtkPointSet*>& blocks, int association, const Numbers& numbers,
  vtkDataSetAttributes* output)
{
  vtkDataSetAttributes::FieldList arrays(static_cast<int>(blocks.size()));
  for (vtkPointSet* block : blocks)
  {
    arrays.IntersectFieldList(block->GetAttributes(association));
  }
  output->CopyAllOn(); // global ids, too
  output->CopyAllocate(arrays, static_cast<vtkIdType>(numbers.size()));
  std::size_t next = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    vtkDataSetAttributes* input = blocks[i]->GetAttributes(association);
    for (vtkIdType id = 0; id < blocks[i]->GetNumberOfElements(association); ++id, ++next)
    {
      if (numbers[next] >= 0)
      {
        output->CopyData(arrays, input, static_cast<int>(i), id, numbers[next]);
      }
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkSurfaceBlocks::vtkSurfaceBlocks(vtkDataObject* input)
  : Blocks(BlocksOf(input))
{
}

//------------------------------------------------------------------------------
std::int64_t vtkSurfaceBlocks::GetNumberOfCells() const
{
  std::int64_t cells = 0;
  for (vtkPointSet* block : this->Blocks)
  {
    cells += block->GetNumberOfCells();
  }
  return cells;
}

//------------------------------------------------------------------------------
medial::MeshInput vtkSurfaceBlocks::ToMeshInput() const
{
  medial::MeshInput mesh;
  std::int64_t cells = 0;
  for (vtkPointSet* block : this->Blocks)
  {
    AppendBlock(block, cells, mesh);
    cells += block->GetNumberOfCells();
  }
  return mesh;
}

//------------------------------------------------------------------------------
Numbers vtkSurfaceBlocks::GlobalCellIds() const
{
  return GlobalIds(this->Blocks, vtkDataObject::CELL, "vtkGlobalCellIds");
}

//------------------------------------------------------------------------------
Numbers vtkSurfaceBlocks::GlobalPointIds() const
{
  return GlobalIds(this->Blocks, vtkDataObject::POINT, "vtkGlobalPointIds");
}

//------------------------------------------------------------------------------
OutputNumbers vtkSurfaceBlocks::ToPolyData(const std::vector<char>& isLeftOut,
  vtkPolyData* output) const
{
  if (this->Blocks.empty())
  {
    return {};
  }
  const medial::MeshInput cells = this->ToMeshInput();
  OutputNumbers numbers = NumbersOf(cells, isLeftOut);
  output->SetPoints(PointsOf(this->Blocks, cells.points, numbers.Points));
  output->SetVerts(CellsOf(cells.verts, numbers));
  output->SetLines(CellsOf(cells.lines, numbers));
  output->SetPolys(CellsOf(cells.polygons, numbers));
  output->SetStrips(CellsOf(cells.strips, numbers));
  CopyArrays(this->Blocks, vtkDataObject::POINT, numbers.Points, output->GetPointData());
  CopyArrays(this->Blocks, vtkDataObject::CELL, numbers.Cells, output->GetCellData());
  output->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName()); // none is one
  return numbers;
}
