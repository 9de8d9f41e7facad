#include "ranks/surface_part.h"

#include <algorithm>
#include <set>

namespace medial
{
namespace
{

/// As many triangles without area in a row as pseudonormals see through, and one more.
constexpr int kMaxRow = 17;

bool isFlat(const FaceRecord& face)
{
  return !hasArea(face.points[0], face.points[1], face.points[2]);
}

} // namespace

SurfacePart::SurfacePart(std::vector<FaceRecord> faces)
  : faces_(std::move(faces))
{
  std::sort(faces_.begin(), faces_.end(),
    [](const FaceRecord& a, const FaceRecord& b) { return a.face < b.face; });
  faces_.erase(std::unique(faces_.begin(), faces_.end(),
                 [](const FaceRecord& a, const FaceRecord& b) { return a.face == b.face; }),
    faces_.end());
  faces_.shrink_to_fit(); // ranks have sent many of them twice
  for (const FaceRecord& face : faces_)
  {
    points_.insert(points_.end(), face.corners.begin(), face.corners.end());
  }
  std::sort(points_.begin(), points_.end());
  points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  points_.shrink_to_fit();
  mesh_.triangles.reserve(faces_.size());
  mesh_.triangleCells.reserve(faces_.size());
  mesh_.points.resize(points_.size());
  for (const FaceRecord& face : faces_)
  {
    std::array<int, 3> corners{};
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = static_cast<int>(
        std::lower_bound(points_.begin(), points_.end(), face.corners[i]) - points_.begin());
      mesh_.points[corners[i]] = face.points[i];
    }
    mesh_.triangles.push_back(corners);
    mesh_.triangleCells.push_back(face.cell);
  }
  connectivity_ = analyseConnectivity(mesh_);
}

int SurfacePart::faceOf(int number) const
{
  return static_cast<int>(std::lower_bound(faces_.begin(), faces_.end(), number,
                            [](const FaceRecord& face, int wanted) { return face.face < wanted; }) -
    faces_.begin());
}

std::vector<std::int32_t> SurfacePart::siteNumbers(const DistributedSurface& surface) const
{
  std::vector<std::int32_t> numbers(faces_.size() + connectivity_.edges.size() + points_.size());
  const std::size_t firstEdge = faces_.size();
  const std::size_t firstVertex = firstEdge + connectivity_.edges.size();
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    numbers[i] = faces_[i].face;
    for (int corner = 0; corner < 3; ++corner)
    {
      numbers[firstEdge + connectivity_.triangleEdges[i][corner]] =
        surface.faceCount() + faces_[i].edges[corner];
    }
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    numbers[firstVertex + i] = surface.faceCount() + surface.edgeCount() + points_[i];
  }
  return numbers;
}

Neighbourhoods::Neighbourhoods(const SurfacePart& part)
  : part_(part)
  , facesOfPoint_(part.mesh().points.size())
{
  for (std::size_t face = 0; face < part.mesh().triangles.size(); ++face)
  {
    for (const int corner : part.mesh().triangles[face])
    {
      facesOfPoint_[corner].push_back(static_cast<int>(face));
    }
  }
}

void Neighbourhoods::collect(const std::vector<int>& faces, std::vector<FaceRecord>& found) const
{
  std::set<int> all(faces.begin(), faces.end());
  std::vector<int> next = faces;
  for (int row = 0; row <= kMaxRow && !next.empty(); ++row)
  {
    std::vector<int> flat;
    for (const int face : next)
    {
      for (const int corner : part_.mesh().triangles[face])
      {
        for (const int neighbour : facesOfPoint_[corner])
        {
          if (all.insert(neighbour).second && isFlat(part_.faces()[neighbour]))
          {
            flat.push_back(neighbour);
          }
        }
      }
    }
    next = std::move(flat);
  }
  for (const int face : all)
  {
    found.push_back(part_.faces()[face]);
  }
}

std::vector<FaceRecord> withNeighbours(Communicator& communicator,
  const DistributedSurface& surface, std::vector<int> points)
{
  std::set<int> known;
  std::vector<FaceRecord> faces;
  for (int row = 0; row <= kMaxRow; ++row)
  {
    std::vector<int> wanted;
    for (const int point : points)
    {
      if (known.insert(point).second)
      {
        wanted.push_back(point);
      }
    }
    const std::vector<FaceRecord> found = surface.around(communicator, wanted);
    points.clear();
    for (const FaceRecord& face : found)
    {
      if (isFlat(face))
      {
        points.insert(points.end(), face.corners.begin(), face.corners.end());
      }
    }
    faces.insert(faces.end(), found.begin(), found.end());
    if (maximum(communicator, points.empty() ? 0 : 1) == 0)
    {
      break;
    }
  }
  return faces;
}

} // namespace medial
