#include "ranks/surface/surface_part.h"

#include "ranks/surface/point_rings.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// So many triangles are fetched at once: as they travel they take twice the memory.
constexpr std::size_t kFetchedAtOnce = std::size_t{ 1 } << 17;

} // namespace

SurfacePart::SurfacePart(std::vector<FaceRecord> faces)
{
  std::sort(faces.begin(), faces.end(),
    [](const FaceRecord& a, const FaceRecord& b) { return a.face < b.face; });
  faces.erase(std::unique(faces.begin(), faces.end(),
                [](const FaceRecord& a, const FaceRecord& b) { return a.face == b.face; }),
    faces.end());
  this->reserve(faces.size());
  std::vector<NumberedPoint> points;
  std::vector<std::array<int, 3>> edges;
  this->add(faces, points, edges);
  std::vector<FaceRecord>().swap(faces);
  this->finish(std::move(points), std::move(edges));
}

SurfacePart::SurfacePart(Communicator& communicator, const DistributedSurface& surface,
  std::vector<int> faces)
{
  this->reserve(faces.size());
  std::vector<NumberedPoint> points;
  std::vector<std::array<int, 3>> edges;
  edges.reserve(faces.size());
  const std::size_t most = maximum(communicator, faces.size());
  for (std::size_t begin = 0; begin < most; begin += kFetchedAtOnce)
  {
    const auto at = [&](std::size_t place)
    { return faces.begin() + static_cast<std::ptrdiff_t>(std::min(place, faces.size())); };
    this->add(surface.fetch(communicator, { at(begin), at(begin + kFetchedAtOnce) }), points,
      edges);
  }
  std::vector<int>().swap(faces);
  this->finish(std::move(points), std::move(edges));
}

void SurfacePart::reserve(std::size_t faces)
{
  faces_.reserve(faces);
  mesh_.triangles.reserve(faces);
  mesh_.triangleCells.reserve(faces);
}

void SurfacePart::add(const std::vector<FaceRecord>& faces, std::vector<NumberedPoint>& points,
  std::vector<std::array<int, 3>>& edges)
{
  const auto isBefore = [](const NumberedPoint& a, const NumberedPoint& b)
  { return a.number < b.number; };
  std::vector<NumberedPoint> corners;
  corners.reserve(3 * faces.size());
  for (const FaceRecord& face : faces)
  {
    faces_.push_back(face.face);
    edges.push_back(face.edges);
    mesh_.triangles.push_back(face.corners);
    mesh_.triangleCells.push_back(face.cell);
    for (int i = 0; i < 3; ++i)
    {
      corners.push_back({ face.corners[i], face.points[i] });
    }
  }
  std::sort(corners.begin(), corners.end(), isBefore);
  corners.erase(std::unique(corners.begin(), corners.end(),
                  [](const NumberedPoint& a, const NumberedPoint& b)
                  { return a.number == b.number; }),
    corners.end());
  std::vector<NumberedPoint> all;
  all.reserve(points.size() + corners.size());
  std::set_union(points.begin(), points.end(), corners.begin(), corners.end(),
    std::back_inserter(all), isBefore);
  points = std::move(all);
}

void SurfacePart::finish(std::vector<NumberedPoint> points, std::vector<std::array<int, 3>> edges)
{
  points_.reserve(points.size());
  mesh_.points.reserve(points.size());
  for (const NumberedPoint& point : points)
  {
    points_.push_back(point.number);
    mesh_.points.push_back(point.position);
  }
  std::vector<NumberedPoint>().swap(points);
  for (std::array<int, 3>& corners : mesh_.triangles)
  {
    for (int& corner : corners)
    {
      corner = static_cast<int>(
        std::lower_bound(points_.begin(), points_.end(), corner) - points_.begin());
    }
  }
  connectivity_ = analyseConnectivity(mesh_);
  edges_.resize(connectivity_.edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    for (int side = 0; side < 3; ++side)
    {
      edges_[connectivity_.triangleEdges[i][side]] = edges[i][side];
    }
  }
}

void SurfacePart::dropGeometry()
{
  decltype(mesh_.points)().swap(mesh_.points);
  decltype(mesh_.triangles)().swap(mesh_.triangles);
  decltype(connectivity_.edges)().swap(connectivity_.edges);
  decltype(connectivity_.triangleEdges)().swap(connectivity_.triangleEdges);
}

int SurfacePart::faceOf(int number) const
{
  return static_cast<int>(std::lower_bound(faces_.begin(), faces_.end(), number) - faces_.begin());
}

std::vector<std::int32_t> SurfacePart::siteNumbers(const DistributedSurface& surface) const
{
  std::vector<std::int32_t> numbers(faces_.size() + edges_.size() + points_.size());
  const auto firstEdge = static_cast<std::ptrdiff_t>(faces_.size());
  const auto firstVertex = firstEdge + static_cast<std::ptrdiff_t>(edges_.size());
  std::copy(faces_.begin(), faces_.end(), numbers.begin());
  std::transform(edges_.begin(), edges_.end(), numbers.begin() + firstEdge,
    [&](int edge) { return surface.faceCount() + edge; });
  std::transform(points_.begin(), points_.end(), numbers.begin() + firstVertex,
    [&](int point) { return surface.faceCount() + surface.edgeCount() + point; });
  return numbers;
}

void addNeighbours(const SurfacePart& part, std::vector<int>& faces)
{
  const TriangleMesh& mesh = part.mesh();
  const MeshConnectivity& connectivity = part.connectivity();
  const auto isFlat = [&](int face)
  {
    const auto& [a, b, c] = mesh.triangles[face];
    return !hasArea(mesh.points[a], mesh.points[b], mesh.points[c]);
  };
  std::vector<char> known(mesh.triangles.size(), 0);
  for (const int face : faces)
  {
    known[face] = 1;
  }
  std::vector<int> next = faces;
  for (int row = 0; row <= kMaxFlatRow && !next.empty(); ++row)
  {
    std::vector<int> flat;
    const auto visit = [&](int face)
    {
      if (known[face] == 0)
      {
        known[face] = 1;
        faces.push_back(face);
        if (isFlat(face))
        {
          flat.push_back(face);
        }
      }
    };
    for (const int face : next)
    {
      for (const int corner : mesh.triangles[face])
      {
        std::for_each(connectivity.pointEdges.begin(corner), connectivity.pointEdges.end(corner),
          [&](int edge)
          {
            std::for_each(connectivity.edgeTriangles.begin(edge),
              connectivity.edgeTriangles.end(edge), visit);
          });
      }
    }
    next = std::move(flat);
  }
}

} // namespace medial
