#include "base/run.h"
#include "base/sorted_set.h"
#include "medial/ranks.h"
#include "medial/thickness_regions.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"
#include "ranks/surface/shared_sign.h"
#include "sites/grid_frame.h"
#include "thickness/region_checks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

namespace medial
{
namespace
{

/// A triangle beyond a limit.
struct BeyondFace
{
  int rank;
  int triangle; ///< of the rank's piece
  int face;     ///< its number in the whole
  float value;
  std::array<int, 3> corners; ///< points, numbers in the whole
  std::array<Point3, 3> points;
  std::array<float, 3> cornerValues;
  std::array<char, 3> cornerAtEdge;
};

/// A region as all ranks know it.
struct RegionFigures
{
  bool thin;
  double area;
  double value;
  Point3 place;
};

/// Returns the numbers in the whole of the triangles of this rank's piece.
std::vector<int> numbersOfTriangles(Communicator& communicator, const DistributedSurface& surface,
  std::size_t triangles)
{
  struct Sent
  {
    DistributedSurface::Origin to;
    int face;
  };
  std::vector<Sent> sent;
  for (std::size_t i = 0; i < surface.faces().size(); ++i)
  {
    sent.push_back({ surface.origins()[i], surface.faces()[i].face });
  }
  std::vector<int> numbers(triangles);
  for (const Sent& received :
    delivered(communicator, sent, [](const Sent& item) { return item.to.rank; }))
  {
    numbers[received.to.triangle] = received.face;
  }
  return numbers;
}

std::vector<BeyondFace> beyondLimits(Communicator& communicator, const SurfacePiece& piece,
  const Thickness& thickness, const ThicknessLimits& limits)
{
  const DistributedSurface surface(communicator, piece);
  const TriangleMesh& mesh = piece.mesh;
  const std::vector<int> numbers = numbersOfTriangles(communicator, surface, mesh.triangles.size());
  std::vector<BeyondFace> faces;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (beyondOf(thickness.triangleValues[i], thickness.triangleAtEdge[i] != 0, limits) ==
      Beyond::Nothing)
    {
      continue;
    }
    BeyondFace face{ communicator.rank(), static_cast<int>(i), numbers[i],
      thickness.triangleValues[i], {}, {}, {}, {} };
    for (int k = 0; k < 3; ++k)
    {
      const int corner = mesh.triangles[i][k];
      face.corners[k] = surface.pointsOfPiece()[corner];
      face.points[k] = mesh.points[corner];
      face.cornerValues[k] = thickness.values[corner];
      face.cornerAtEdge[k] = thickness.atEdge[corner];
    }
    faces.push_back(face);
  }
  return faces;
}

/// Finds the regions of triangles that are all beyond limits, in the order of the whole.
std::vector<ThicknessRegion> regionsOf(const std::vector<BeyondFace>& faces,
  const ThicknessLimits& limits)
{
  std::map<int, int> points;
  for (const BeyondFace& face : faces)
  {
    for (const int corner : face.corners)
    {
      points.insert({ corner, 0 });
    }
  }
  int next = 0;
  for (auto& [number, point] : points)
  {
    point = next++;
  }
  TriangleMesh mesh;
  mesh.points.resize(points.size());
  Thickness thickness;
  thickness.values.resize(points.size());
  thickness.atEdge.resize(points.size());
  for (const BeyondFace& face : faces)
  {
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = points[face.corners[k]];
      mesh.points[corners[k]] = face.points[k];
      thickness.values[corners[k]] = face.cornerValues[k];
      thickness.atEdge[corners[k]] = face.cornerAtEdge[k];
    }
    mesh.triangles.push_back(corners);
    thickness.triangleValues.push_back(face.value);
  }
  mesh.triangleCells.resize(faces.size());
  thickness.triangleAtEdge.resize(faces.size(), 0);
  return findThicknessRegions(mesh, thickness, limits);
}

} // namespace

void requireInside(Communicator& communicator, const SurfacePiece& piece,
  const Execution& execution)
{
  agree(communicator,
    [&]
    {
      const DistributedSurface surface(communicator, piece);
      const DistributedSurface::EdgeCounts& edges = surface.edgeCounts();
      if (edges.boundary + edges.nonManifold == 0)
      {
        return;
      }
      const Run run(execution);
      const Grid grid = gridForInside(surface.bounds());
      const SharedSign sign(communicator, surface, SignMethod::Auto, grid, GridFrame(grid), run);
      requireSign(sign.report());
    });
}

std::vector<ThicknessRegion> findThicknessRegions(Communicator& communicator,
  const SurfacePiece& piece, const Thickness& thickness, const ThicknessLimits& limits)
{
  struct Member
  {
    int rank;
    int triangle;
    int region;
  };
  std::vector<ThicknessRegion> regions;
  agree(communicator,
    [&]
    {
      checkThicknessLimits(limits);
      requireValuesOf(piece.mesh, thickness);
      std::vector<BeyondFace> faces = delivered(communicator,
        beyondLimits(communicator, piece, thickness, limits), [](const BeyondFace&) { return 0; });
      std::sort(faces.begin(), faces.end(),
        [](const BeyondFace& a, const BeyondFace& b) { return a.face < b.face; });
      std::vector<RegionFigures> figures;
      std::vector<Member> members;
      for (const ThicknessRegion& region : regionsOf(faces, limits))
      {
        for (const int triangle : region.triangles)
        {
          members.push_back(
            { faces[triangle].rank, faces[triangle].triangle, static_cast<int>(figures.size()) });
        }
        figures.push_back({ region.thin, region.area, region.value, region.place });
      }
      figures = gathered(communicator, figures).front();
      for (const RegionFigures& region : figures)
      {
        regions.push_back({ region.thin, region.area, region.value, region.place, {}, {} });
      }
      for (const Member& member :
        delivered(communicator, members, [](const Member& sent) { return sent.rank; }))
      {
        regions[member.region].triangles.push_back(member.triangle);
        regions[member.region].cells.push_back(piece.mesh.triangleCells[member.triangle]);
      }
      for (ThicknessRegion& region : regions)
      {
        std::sort(region.triangles.begin(), region.triangles.end());
        makeSet(region.cells);
      }
    });
  return regions;
}

} // namespace medial
