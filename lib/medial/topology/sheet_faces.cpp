#include "medial/medial/topology/sheet_faces.h"

namespace medial
{
namespace
{

bool isInside(const CellLattice& lattice, Cell vertex)
{
  for (const Cell step : lattice.cofaces(kVertexKind))
  {
    const Cell edge = vertex + step;
    if (lattice.has(edge) && lattice.cofaceCount(edge) == 1)
    {
      return false;
    }
  }
  return true;
}

bool isInSheet(const CellLattice& lattice, Cell face)
{
  for (const Cell step : lattice.faces(CellLattice::kind(face)))
  {
    const Cell edge = face + step;
    for (const Cell end : lattice.faces(CellLattice::kind(edge)))
    {
      if (isInside(lattice, edge + end))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

SheetSplit splitSheets(const CellLattice& lattice, const std::vector<Cell>& faces)
{
  SheetSplit split;
  for (const Cell face : faces)
  {
    (isInSheet(lattice, face) ? split.sheets : split.strips).push_back(face);
  }
  return split;
}

SheetSplit splitSheets(const glm::ivec3& size, const std::vector<Cell>& faces)
{
  CellLattice lattice(size);
  for (const Cell face : faces)
  {
    lattice.insert(face);
    for (const Cell step : lattice.faces(CellLattice::kind(face)))
    {
      const Cell edge = face + step;
      lattice.insert(edge);
      for (const Cell end : lattice.faces(CellLattice::kind(edge)))
      {
        lattice.insert(edge + end);
      }
    }
  }
  return splitSheets(lattice, faces);
}

} // namespace medial
