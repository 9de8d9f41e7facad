#include "support/culling_cases.h"

#include "support/shapes.h"

#include <array>
#include <cmath>

namespace medial::test
{
namespace
{

/// Twelve faces in pairs that are equal and opposite, so that edges have many faces.
TriangleMesh bookOfFaces()
{
  std::vector<Point3> points{ { 0.0, 0.0, -0.5 }, { 0.0, 0.0, 0.5 } };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < 6; ++i)
  {
    points.push_back({ std::cos(1.1 * i), std::sin(1.1 * i), 0.2 * i - 0.5 });
    triangles.push_back({ 0, 1, i + 2 });
    triangles.push_back({ 1, 0, i + 2 });
  }
  return makeMesh(points, triangles);
}

/// Two shallow cones with a common rim, whose faces all have normals upwards: at the rim one turns
/// its inside out.
TriangleMesh turnedLens()
{
  constexpr int kRim = 24;
  constexpr double kTurn = 2.0 * 3.14159265358979 / kRim;
  std::vector<Point3> points{ { 0.0, 0.0, 0.2 }, { 0.0, 0.0, -0.2 } };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < kRim; ++i)
  {
    const int next = 2 + (i + 1) % kRim;
    points.push_back({ std::cos(kTurn * i), std::sin(kTurn * i), 0.0 });
    triangles.push_back({ 0, i + 2, next });
    triangles.push_back({ 1, i + 2, next });
  }
  return makeMesh(points, triangles);
}

/// Triangles whose long edge is split on one side, with the gaps filled by triangles without area.
TriangleMesh filledSplits()
{
  return makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 },
                    { 1.5, 1.0, 0.5 }, { 1.5, -1.0, 0.5 } },
    { { 0, 1, 3 }, { 1, 2, 3 }, { 0, 3, 4 }, { 0, 5, 1 }, { 1, 5, 2 }, { 2, 5, 3 } });
}

} // namespace

std::ostream& operator<<(std::ostream& stream, const CullingCase& culling)
{
  return stream << culling.name;
}

std::vector<CullingCase> cullingCases()
{
  const auto around = [](const char* name, const TriangleMesh& mesh, int resolution) -> CullingCase
  {
    return { name, mesh, makeGrid(mesh.bounds(), resolution, 0.15) };
  };
  const TriangleMesh ring = torus(1.0, 0.4, 16, 8);
  return { around("box", box({ 1.0, 0.6, 0.3 }), 37), around("torus", ring, 29),
    around("soup", randomSoup(40, 4), 31), around("manyFacedEdge", bookOfFaces(), 27),
    around("needles", wedge(2.0, 1.0, 1.0), 33), around("turnedLens", turnedLens(), 31),
    around("filledSplits", filledSplits(), 31),
    around("pointsAndSegments",
      makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.4 }, { 0.5, 0.9, 0.3 } }, {}, { { 0, 1 } },
        { 2 }),
      21),
    { "unequalSpacing", ring, { { -1.5, -1.5, -0.6 }, { 0.06, 0.1, 0.21 }, { 51, 31, 7 } } },
    { "oneSlice", ring, { { -1.5, -1.5, 0.13 }, { 0.06, 0.06, 0.06 }, { 51, 51, 1 } } },
    { "outside", ring, { { 3.0, 2.0, 4.0 }, { 0.1, 0.1, 0.1 }, { 20, 17, 19 } } } };
}

} // namespace medial::test
