#include "vtkSurfacePiece.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
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
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

namespace
{

using Numbers = std::vector<std::int64_t>;

//------------------------------------------------------------------------------
[[noreturn]] void Refuse(const std::string& message)
{
  throw medial::Error(medial::ErrorCode::InvalidInput, message);
}

//------------------------------------------------------------------------------
void AddBlock(vtkDataObject* block, std::vector<vtkDataSet*>& blocks)
{
  auto* data = vtkDataSet::SafeDownCast(block);
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
std::vector<vtkDataSet*> BlocksOf(vtkDataObject* input)
{
  std::vector<vtkDataSet*> blocks;
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
// The global ids of all blocks, or none if some has none. Some filters keep such ids without
// marking them, under their usual name.
Numbers GlobalIds(const std::vector<vtkDataSet*>& blocks, int association, const char* name)
{
  Numbers numbers;
  for (vtkDataSet* block : blocks)
  {
    vtkDataSetAttributes* attributes = block->GetAttributes(association);
    vtkDataArray* ids = attributes->GetGlobalIds();
    ids = ids ? ids : attributes->GetArray(name);
    if (!ids)
    {
      return {};
    }
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
medial::CellList& ListFor(vtkDataSet* block, vtkIdType cell, medial::MeshInput& mesh)
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
void AppendBlock(vtkDataSet* block, std::int64_t firstCell, medial::MeshInput& mesh)
{
  const auto firstPoint = static_cast<std::int64_t>(mesh.points.size());
  for (vtkIdType point = 0; point < block->GetNumberOfPoints(); ++point)
  {
    mesh.points.emplace_back();
    block->GetPoint(point, mesh.points.back().data());
  }
  vtkDataArray* ghosts = block->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
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
// The points and cells of blocks, one after the other, without ghosts.
medial::MeshInput InputOf(const std::vector<vtkDataSet*>& blocks)
{
  medial::MeshInput mesh;
  std::int64_t cells = 0;
  for (vtkDataSet* block : blocks)
  {
    AppendBlock(block, cells, mesh);
    cells += block->GetNumberOfCells();
  }
  return mesh;
}

//------------------------------------------------------------------------------
// The numbers of the cells of triangles, segments and vertices.
std::array<Numbers*, 3> CellNumbersOf(medial::TriangleMesh& mesh)
{
  return { &mesh.triangleCells, &mesh.segmentCells, &mesh.vertexCells };
}

//------------------------------------------------------------------------------
// The numbers that an output gives to points and cells; -1 to those that it leaves out.
struct OutputNumbers
{
  Numbers Points;
  Numbers Cells;
};

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
vtkSmartPointer<vtkPoints> PointsOf(const std::vector<vtkDataSet*>& blocks,
  const std::vector<medial::Point3>& points, const Numbers& numbers)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  const bool allAreFloats = std::all_of(blocks.begin(), blocks.end(),
    [](vtkDataSet* block)
    { return vtkPointSet::SafeDownCast(block)->GetPoints()->GetDataType() == VTK_FLOAT; });
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
void CopyArrays(const std::vector<vtkDataSet*>& blocks, int association, const Numbers& numbers,
  vtkDataSetAttributes* output)
{
  vtkDataSetAttributes::FieldList arrays(static_cast<int>(blocks.size()));
  for (vtkDataSet* block : blocks)
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

//------------------------------------------------------------------------------
// Calls visit(triangle, number of the triangle within its cell) for all.
template <typename Visitor>
void VisitCells(const medial::TriangleMesh& mesh, const Visitor& visit)
{
  std::int64_t part = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    part = i > 0 && mesh.triangleCells[i] == mesh.triangleCells[i - 1] ? part + 1 : 0;
    visit(i, part);
  }
}

//------------------------------------------------------------------------------
// What all pieces together are like.
vtkPieceFacts Together(const std::vector<vtkPieceFacts>& facts)
{
  vtkPieceFacts all;
  all.CellIds = true;
  all.PointIds = true;
  for (const vtkPieceFacts& piece : facts)
  {
    all.CellIds = all.CellIds && (piece.Empty || piece.CellIds);
    all.PointIds = all.PointIds && (piece.Empty || piece.PointIds);
    all.TrianglesOfCell = std::max(all.TrianglesOfCell, piece.TrianglesOfCell);
    all.LargestCell = std::max(all.LargestCell, piece.LargestCell);
  }
  return all;
}

//------------------------------------------------------------------------------
// Numbers points by the first triangle that uses them. The result does not depend on the pieces,
// since of points at one place the lowest number counts.
Numbers OrderOfUse(const medial::TriangleMesh& mesh, const vtkPieceFacts& all, int rank)
{
  const std::int64_t perCell = 3 * all.TrianglesOfCell;
  if (all.LargestCell > (std::int64_t{ 1 } << 61) / std::max<std::int64_t>(perCell, 1))
  {
    Refuse("the global id " + std::to_string(all.LargestCell) + " of a cell is too large");
  }
  // Points of no triangle come last, each with a number of its own.
  Numbers order(mesh.points.size());
  std::iota(order.begin(), order.end(),
    (all.LargestCell + 1) * perCell + (static_cast<std::int64_t>(rank) << 32));
  VisitCells(mesh,
    [&](std::size_t triangle, std::int64_t part)
    {
      for (std::int64_t corner = 0; corner < 3; ++corner)
      {
        std::int64_t& number = order[mesh.triangles[triangle][corner]];
        number = std::min(number, mesh.triangleCells[triangle] * perCell + 3 * part + corner);
      }
    });
  return order;
}

//------------------------------------------------------------------------------
Numbers LowestIds(const medial::TriangleMesh& mesh, const Numbers& ids)
{
  Numbers lowest(mesh.points.size(), std::numeric_limits<std::int64_t>::max());
  for (std::size_t i = 0; i < mesh.pointOfInput.size(); ++i)
  {
    if (mesh.pointOfInput[i] >= 0)
    {
      std::int64_t& id = lowest[mesh.pointOfInput[i]];
      id = std::min(id, ids[i]);
    }
  }
  return lowest;
}

} // namespace

//------------------------------------------------------------------------------
vtkSurfacePiece::vtkSurfacePiece(vtkDataObject* input)
{
  const std::vector<vtkDataSet*> blocks = BlocksOf(input);
  const medial::MeshInput mesh = InputOf(blocks);
  for (vtkDataSet* block : blocks)
  {
    this->Cells += block->GetNumberOfCells();
  }
  if (mesh.verts.size() + mesh.lines.size() + mesh.polygons.size() + mesh.strips.size() > 0)
  {
    this->CellIds = GlobalIds(blocks, vtkDataObject::CELL, "vtkGlobalCellIds");
    this->PointIds = GlobalIds(blocks, vtkDataObject::POINT, "vtkGlobalPointIds");
    this->Mesh = medial::buildTriangleMesh(mesh);
  }
}

//------------------------------------------------------------------------------
vtkPieceFacts vtkSurfacePiece::Facts() const
{
  vtkPieceFacts facts;
  facts.Bounds = this->Mesh.bounds();
  facts.Empty = this->Mesh.empty();
  facts.CellIds = !this->CellIds.empty();
  facts.PointIds = !this->PointIds.empty();
  VisitCells(this->Mesh,
    [&](std::size_t, std::int64_t part)
    { facts.TrianglesOfCell = std::max(facts.TrianglesOfCell, part + 1); });
  if (facts.CellIds)
  {
    facts.LargestCell = *std::max_element(this->CellIds.begin(), this->CellIds.end());
  }
  return facts;
}

//------------------------------------------------------------------------------
medial::SurfacePiece vtkSurfacePiece::Numbered(medial::Communicator& communicator,
  const std::vector<vtkPieceFacts>& facts)
{
  this->IsCopy.assign(static_cast<std::size_t>(this->Cells), 0);
  const auto mark = [this](char isCopy)
  {
    for (const std::int64_t cell : this->Mesh.triangleCells)
    {
      this->IsCopy[cell] = isCopy;
    }
  };
  mark(1);
  medial::dropCopies(communicator, this->Mesh);
  mark(0);
  for (std::size_t i = 0; i < this->InputCells.size(); ++i)
  {
    this->InputCells[i] = *CellNumbersOf(this->Mesh)[i];
  }
  const vtkPieceFacts all = Together(facts);
  medial::SurfacePiece piece;
  if (all.CellIds)
  {
    piece.mesh = std::move(this->Mesh);
    for (Numbers* cells : CellNumbersOf(piece.mesh))
    {
      std::transform(cells->begin(), cells->end(), cells->begin(),
        [this](std::int64_t cell) { return this->CellIds[cell]; });
    }
    piece.pointOrder = OrderOfUse(piece.mesh, all, communicator.rank());
  }
  else
  {
    const auto points = static_cast<std::int64_t>(this->Mesh.pointOfInput.size());
    piece = medial::inRankOrder(communicator, std::move(this->Mesh), points, this->Cells);
  }
  if (all.PointIds)
  {
    piece.pointOrder = LowestIds(piece.mesh, this->PointIds);
  }
  return piece;
}

//------------------------------------------------------------------------------
void vtkSurfacePiece::ToPolyData(vtkDataObject* input, medial::TriangleMesh& mesh,
  vtkPolyData* output) const
{
  output->GetFieldData()->PassData(input->GetFieldData());
  const std::vector<vtkDataSet*> blocks = BlocksOf(input);
  if (blocks.empty())
  {
    return;
  }
  const medial::MeshInput cells = InputOf(blocks);
  const OutputNumbers numbers = NumbersOf(cells, this->IsCopy);
  output->SetPoints(PointsOf(blocks, cells.points, numbers.Points));
  output->SetVerts(CellsOf(cells.verts, numbers));
  output->SetLines(CellsOf(cells.lines, numbers));
  output->SetPolys(CellsOf(cells.polygons, numbers));
  output->SetStrips(CellsOf(cells.strips, numbers));
  CopyArrays(blocks, vtkDataObject::POINT, numbers.Points, output->GetPointData());
  CopyArrays(blocks, vtkDataObject::CELL, numbers.Cells, output->GetCellData());
  output->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName()); // none is one
  std::vector<int> points;
  for (std::size_t i = 0; i < mesh.pointOfInput.size(); ++i)
  {
    if (numbers.Points[i] >= 0)
    {
      points.push_back(mesh.pointOfInput[i]);
    }
  }
  mesh.pointOfInput = std::move(points);
  for (std::size_t i = 0; i < this->InputCells.size(); ++i)
  {
    std::transform(this->InputCells[i].begin(), this->InputCells[i].end(),
      CellNumbersOf(mesh)[i]->begin(), [&](std::int64_t cell) { return numbers.Cells[cell]; });
  }
}
