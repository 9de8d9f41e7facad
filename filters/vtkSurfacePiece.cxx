#include "vtkSurfacePiece.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTriangleCopies.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include "medial/error.h"

#include <algorithm>
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
  medial::MeshInput mesh;
  for (vtkDataSet* block : blocks)
  {
    AppendBlock(block, this->Cells, mesh);
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
void vtkSurfacePiece::Drop(const std::vector<char>& triangles)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (triangles[i] == 0)
    {
      this->Mesh.triangles[kept] = this->Mesh.triangles[i];
      this->Mesh.triangleCells[kept++] = this->Mesh.triangleCells[i];
    }
  }
  this->Mesh.triangles.resize(kept);
  this->Mesh.triangleCells.resize(kept);
}

//------------------------------------------------------------------------------
medial::SurfacePiece vtkSurfacePiece::Numbered(medial::Communicator& communicator,
  const std::vector<vtkPieceFacts>& facts)
{
  this->Drop(vtkFindCopies(communicator, this->Mesh, facts));
  const vtkPieceFacts all = Together(facts);
  medial::SurfacePiece piece;
  if (all.CellIds)
  {
    piece.mesh = std::move(this->Mesh);
    for (Numbers* cells :
      { &piece.mesh.triangleCells, &piece.mesh.segmentCells, &piece.mesh.vertexCells })
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
