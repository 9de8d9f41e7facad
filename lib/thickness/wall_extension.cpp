#include "thickness/wall_extension.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

/// A strip without a value is at most this wide, in thicknesses of the wall beside it.
constexpr double kStrip = 0.5;
/// What belongs to a wall is at most this far away, in its thicknesses: a strip and half of a
/// narrow side.
constexpr double kWithin = 1.0;
/// There, distances count over thicknesses to this power. By thicknesses themselves the strip of a
/// thick wall would take the narrow sides of a thin one on it, and by world units the thin one a
/// part of that strip.
constexpr double kPower = 0.75;
/// Nothing takes its value from farther away, in thicknesses of the wall: where sides meet at 60
/// degrees, the strip is 0.87 wide, and half of the narrow side 0.58.
constexpr double kFarthest = 1.5;

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
    , known_(mesh.points.size() + mesh.triangles.size())
  {
    for (std::size_t place = 0; place < known_.size(); ++place)
    {
      known_[place] = std::isnan(this->value(static_cast<int>(place))) ? 0 : 1;
    }
    measured_ = known_;
  }

  enum class Reach
  {
    Within,  ///< only to what belongs to a wall
    Farthest ///< to all else nearby, from the wall that is the fewest of its thicknesses away
  };
  void run(Reach reach, const Checkpoint& checkpoint)
  {
    const std::vector<char> sources = known_;
    for (std::size_t place = 0; place < sources.size(); ++place)
    {
      checkpoint(place);
      const auto source = static_cast<int>(place);
      if (sources[place] != 0 && this->value(source) > 0.0F)
      {
        this->leave({ 0.0, source, source }, reach);
      }
    }
    for (std::size_t step = 0; !queue_.empty(); ++step)
    {
      checkpoint(step);
      const Step next = queue_.top();
      queue_.pop();
      const auto [distance, source, place] = next;
      if (known_[place] == 0)
      {
        known_[place] = 1;
        this->copy(source, place);
        this->leave(next, reach);
      }
    }
  }

private:
  using Step = std::tuple<double, int, int>; ///< distance, source, place

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

  bool opensAt(int place) const { return place < pointCount_ && points_.opens[place] != 0; }

  /// Whether the solid opens at an edge of a triangle.
  bool opensAlong(int triangle, int edge) const
  {
    const int bit = bitOfEdge(mesh_.triangles[triangle], connectivity_.edges[edge]);
    return (triangles_.opens[triangle] & bit) != 0;
  }

  void leave(const Step& from, Reach reach)
  {
    const double distance = std::get<0>(from);
    const int source = std::get<1>(from);
    const int place = std::get<2>(from);
    if (this->opensAt(place))
    {
      return;
    }
    const auto thickness = static_cast<double>(this->value(source));
    const bool within = reach == Reach::Within;
    const double unit = within ? std::pow(thickness, kPower) : thickness;
    const double limit = (within ? kWithin : kFarthest) * thickness / unit;
    const double longest =
      measured_[place] != 0 ? kStrip * thickness : std::numeric_limits<double>::infinity();
    this->forEachNext(place,
      [&](int to, double way, double beyond)
      {
        const double there = distance + (std::min(way, longest) + beyond) / unit;
        if (known_[to] == 0 && there <= limit)
        {
          queue_.emplace(there, source, to);
        }
      });
  }

  /// Calls visit(place, way, beyond) for the places next to one. The way to them is in two parts,
  /// of which the first ends at the edge of a triangle.
  template <typename Visit>
  void forEachNext(int place, const Visit& visit) const
  {
    const glm::dvec3 from = this->position(place);
    const auto visitAt = [&](int to) { visit(to, glm::distance(from, this->position(to)), 0.0); };
    if (place >= pointCount_)
    {
      const int triangle = place - pointCount_;
      for (int i = 0; i < 3; ++i)
      {
        visitAt(mesh_.triangles[triangle][i]);
        this->forEachAcross(triangle, connectivity_.triangleEdges[triangle][i], visit);
      }
      return;
    }
    const IncidenceLists& edges = connectivity_.pointEdges;
    for (const int* edge = edges.begin(place); edge != edges.end(place); ++edge)
    {
      const std::array<int, 2>& ends = connectivity_.edges[*edge];
      visitAt(ends[0] == place ? ends[1] : ends[0]);
      const IncidenceLists& triangles = connectivity_.edgeTriangles;
      for (const int* t = triangles.begin(*edge); t != triangles.end(*edge); ++t)
      {
        visitAt(pointCount_ + *t);
      }
    }
  }

  /// The same for the triangles beyond an edge. Where both its ends have a value these are nearer.
  template <typename Visit>
  void forEachAcross(int triangle, int edge, const Visit& visit) const
  {
    const std::array<int, 2>& ends = connectivity_.edges[edge];
    if ((measured_[ends[0]] != 0 && measured_[ends[1]] != 0) || this->opensAlong(triangle, edge))
    {
      return;
    }
    const glm::dvec3 start = this->position(ends[0]);
    const glm::dvec3 along = this->position(ends[1]) - start;
    const double size = glm::length(along);
    const auto toEdge = [&](int t)
    {
      const glm::dvec3 way = this->position(pointCount_ + t) - start;
      return size > 0.0 ? glm::length(glm::cross(way, along)) / size : glm::length(way);
    };
    const IncidenceLists& triangles = connectivity_.edgeTriangles;
    for (const int* t = triangles.begin(edge); t != triangles.end(edge); ++t)
    {
      if (*t != triangle)
      {
        visit(pointCount_ + *t, toEdge(triangle), toEdge(*t));
      }
    }
  }

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  PlaceValues& points_;
  PlaceValues& triangles_;
  int pointCount_;
  std::vector<char> known_;
  std::vector<char> measured_; ///< the places that had a value before
  std::priority_queue<Step, std::vector<Step>, std::greater<>> queue_;
};

} // namespace

void extendWalls(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Checkpoint& checkpoint, PlaceValues& points, PlaceValues& triangles)
{
  Extension extension(mesh, connectivity, points, triangles);
  extension.run(Extension::Reach::Within, checkpoint);
  extension.run(Extension::Reach::Farthest, checkpoint);
}

} // namespace medial
