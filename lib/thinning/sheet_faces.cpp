#include "thinning/sheet_faces.h"

namespace medial
{
namespace
{

bool isInside(const CubicalComplex& complex, CubeCell vertex)
{
  for (const CubeCell step : complex.cofaces(kVertexKind))
  {
    const CubeCell edge = vertex + step;
    if (complex.has(edge) && complex.cofaceCount(edge) == 1)
    {
      return false;
    }
  }
  return true;
}

bool isInSheet(const CubicalComplex& complex, CubeCell face)
{
  for (const CubeCell step : complex.faces(CubicalComplex::kind(face)))
  {
    const CubeCell edge = face + step;
    for (const CubeCell end : complex.faces(CubicalComplex::kind(edge)))
    {
      if (isInside(complex, edge + end))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

SheetSplit splitSheets(const CubicalComplex& complex, const std::vector<CubeCell>& faces)
{
  SheetSplit split;
  for (const CubeCell face : faces)
  {
    (isInSheet(complex, face) ? split.sheets : split.strips).push_back(face);
  }
  return split;
}

SheetSplit splitSheets(const glm::ivec3& size, const std::vector<CubeCell>& faces)
{
  CubicalComplex complex(size);
  for (const CubeCell face : faces)
  {
    complex.insert(face);
    for (const CubeCell step : complex.faces(CubicalComplex::kind(face)))
    {
      const CubeCell edge = face + step;
      complex.insert(edge);
      for (const CubeCell end : complex.faces(CubicalComplex::kind(edge)))
      {
        complex.insert(edge + end);
      }
    }
  }
  return splitSheets(complex, faces);
}

} // namespace medial
