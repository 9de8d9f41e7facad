#include "thickness/wall_extension.h"

#include <glm/glm.hpp>

#include <cmath>
#include <queue>
#include <tuple>
#include <vector>

namespace medial
{
namespace
{

/// Dijkstra's algorithm from all places with a value; places are points, then triangles.
class Extension
{
public:
  Extension(const TriangleMesh& mesh, const MeshConnectivity& connectivity, PlaceValues& points,
    PlaceValues& triangles)
    : mesh_(mesh)
    , connectivity_(connectivity)
    , points_(points)
    , triangles_(triangles)
    , pointCount_(static_cast<int>(mesh.points.size()))
  {
  }

  void run(const Checkpoint& checkpoint)
  {
    const int count = pointCount_ + static_cast<int>(mesh_.triangles.size());
    std::vector<char> known(count);
    for (int place = 0; place < count; ++place)
    {
      known[place] = std::isnan(this->value(place)) ? 0 : 1;
    }
    for (int place = 0; place < count; ++place)
    {
      checkpoint(static_cast<std::size_t>(place));
      if (known[place] && this->value(place) > 0.0F)
      {
        this->leave(place, 0.0, place, known);
      }
    }
    std::size_t step = 0;
    while (!queue_.empty())
    {
      checkpoint(step++);
      const auto [distance, source, place] = queue_.top();
      queue_.pop();
      if (!known[place])
      {
        known[place] = 1;
        this->copy(source, place);
        this->leave(place, distance, source, known);
      }
    }
  }

private:
  using Step = std::tuple<double, int, int>; ///< distance in thicknesses, source, place

  float value(int place) const
  {
    return place < pointCount_ ? points_.values[place] : triangles_.values[place - pointCount_];
  }

  void copy(int from, int to)
  {
    const auto of = [this](int place) -> std::pair<PlaceValues&, int>
    {
      return place < pointCount_ ? std::pair<PlaceValues&, int>(points_, place)
                                 : std::pair<PlaceValues&, int>(triangles_, place - pointCount_);
    };
    const auto [source, i] = of(from);
    const auto [target, j] = of(to);
    target.values[j] = source.values[i];
    target.atEdge[j] = source.atEdge[i];
  }

  glm::dvec3 position(int place) const
  {
    const auto at = [this](int point)
    {
      const Point3& x = mesh_.points[point];
      return glm::dvec3(x[0], x[1], x[2]);
    };
    if (place < pointCount_)
    {
      return at(place);
    }
    const std::array<int, 3>& corners = mesh_.triangles[place - pointCount_];
    return (at(corners[0]) + at(corners[1]) + at(corners[2])) / 3.0;
  }

  void leave(int place, double distance, int source, const std::vector<char>& known)
  {
    const glm::dvec3 from = this->position(place);
    const auto thickness = static_cast<double>(this->value(source));
    const auto visit = [&](int to)
    {
      if (!known[to])
      {
        queue_.emplace(distance + glm::distance(from, this->position(to)) / thickness, source, to);
      }
    };
    if (place >= pointCount_)
    {
      for (const int corner : mesh_.triangles[place - pointCount_])
      {
        visit(corner);
      }
      return;
    }
    const IncidenceLists& edges = connectivity_.pointEdges;
    for (const int* edge = edges.begin(place); edge != edges.end(place); ++edge)
    {
      const std::array<int, 2>& ends = connectivity_.edges[*edge];
      visit(ends[0] == place ? ends[1] : ends[0]);
      const IncidenceLists& triangles = connectivity_.edgeTriangles;
      for (const int* t = triangles.begin(*edge); t != triangles.end(*edge); ++t)
      {
        visit(pointCount_ + *t);
      }
    }
  }

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  PlaceValues& points_;
  PlaceValues& triangles_;
  int pointCount_;
  std::priority_queue<Step, std::vector<Step>, std::greater<>> queue_;
};

} // namespace

void extendWalls(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Checkpoint& checkpoint, PlaceValues& points, PlaceValues& triangles)
{
  Extension(mesh, connectivity, points, triangles).run(checkpoint);
}

} // namespace medial
