#include "vtkSurfacePiece.h"

#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSurfaceBlocks.h"

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
// The numbers of the cells of triangles, segments and vertices.
std::array<Numbers*, 3> CellNumbersOf(medial::TriangleMesh& mesh)
{
  return { &mesh.triangleCells, &mesh.segmentCells, &mesh.vertexCells };
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
    throw medial::Error(medial::ErrorCode::InvalidInput,
      "the global id " + std::to_string(all.LargestCell) + " of a cell is too large");
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
  const vtkSurfaceBlocks blocks(input);
  const medial::MeshInput mesh = blocks.ToMeshInput();
  this->Cells = blocks.GetNumberOfCells();
  if (mesh.verts.size() + mesh.lines.size() + mesh.polygons.size() + mesh.strips.size() > 0)
  {
    this->CellIds = blocks.GlobalCellIds();
    this->PointIds = blocks.GlobalPointIds();
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
  const vtkSurfaceBlocks::OutputNumbers numbers =
    vtkSurfaceBlocks(input).ToPolyData(this->IsCopy, output);
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
