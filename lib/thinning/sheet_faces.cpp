#include "thinning/sheet_faces.h"

namespace medial
{
namespace
{

bool isInside(const CubicalComplex& lattice, CubeCell vertex)
{
  for (const CubeCell step : lattice.cofaces(kVertexKind))
  {
    const CubeCell edge = vertex + step;
    if (lattice.has(edge) && lattice.cofaceCount(edge) == 1)
    {
      return false;
    }
  }
  return true;
}

bool isInSheet(const CubicalComplex& lattice, CubeCell face)
{
  for (const CubeCell step : lattice.faces(CubicalComplex::kind(face)))
  {
    const CubeCell edge = face + step;
    for (const CubeCell end : lattice.faces(CubicalComplex::kind(edge)))
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

SheetSplit splitSheets(const CubicalComplex& lattice, const std::vector<CubeCell>& faces)
{
  SheetSplit split;
  for (const CubeCell face : faces)
  {
    (isInSheet(lattice, face) ? split.sheets : split.strips).push_back(face);
  }
  return split;
}

SheetSplit splitSheets(const glm::ivec3& size, const std::vector<CubeCell>& faces)
{
  CubicalComplex lattice(size);
  for (const CubeCell face : faces)
  {
    lattice.insert(face);
    for (const CubeCell step : lattice.faces(CubicalComplex::kind(face)))
    {
      const CubeCell edge = face + step;
      lattice.insert(edge);
      for (const CubeCell end : lattice.faces(CubicalComplex::kind(edge)))
      {
        lattice.insert(edge + end);
      }
    }
  }
  return splitSheets(lattice, faces);
}

} // namespace medial
