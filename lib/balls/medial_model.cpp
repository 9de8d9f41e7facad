#include "medial/medial_model.h"

#include "balls/ball_check.h"
#include "base/disjoint_sets.h"
#include "base/range_check.h"
#include "base/sorted_set.h"
#include "medial/error.h"
#include "medial/medial_axis.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace medial
{
namespace
{

[[noreturn]] void refuse(const std::ostringstream& message)
{
  throw Error(ErrorCode::InvalidInput, message.str());
}

Point3 difference(const Point3& from, const Point3& to)
{
  return { to[0] - from[0], to[1] - from[1], to[2] - from[2] };
}

Point3 cross(const Point3& u, const Point3& v)
{
  return { u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0] };
}

double norm(const Point3& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

template <typename Cells>
void checkCells(const char* kind, const Cells& cells, std::size_t balls)
{
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    for (const std::int64_t ball : cells[i])
    {
      if (ball < 0 || ball >= static_cast<std::int64_t>(balls))
      {
        throwOutside(std::string(kind) + ' ' + std::to_string(i) + ": ball", ball,
          closedRange<std::int64_t>(0, static_cast<std::int64_t>(balls) - 1));
      }
    }
  }
}

/// Ids in ascending order, so that equal cells compare equal.
template <std::size_t Size>
std::vector<std::array<std::int64_t, Size>> distinct(
  std::vector<std::array<std::int64_t, Size>> cells)
{
  for (auto& cell : cells)
  {
    std::sort(cell.begin(), cell.end());
  }
  makeSet(cells);
  return cells;
}

std::vector<std::array<std::int64_t, 2>> distinctEdges(const MedialModel& model)
{
  std::vector<std::array<std::int64_t, 2>> edges = model.lines;
  const auto addEdges = [&edges](const auto& cells)
  {
    for (const auto& cell : cells)
    {
      for (std::size_t i = 0; i < cell.size(); ++i)
      {
        edges.push_back({ cell[i], cell[(i + 1) % cell.size()] });
      }
    }
  };
  addEdges(model.quads);
  addEdges(model.triangles);
  return distinct(std::move(edges));
}

class Sizes
{
public:
  explicit Sizes(const MedialModel& model)
    : centres_(model.centres)
    , diagonal_(boundsOf(model.centres).diagonal())
  {
  }

  template <typename Cell>
  bool isFlat(const Cell& cell) const
  {
    constexpr double kMinArea = 1e-14; // of the squared diagonal
    Point3 twice{};
    for (std::size_t i = 2; i < cell.size(); ++i)
    {
      const Point3 one = cross(this->vector(cell[0], cell[i - 1]), this->vector(cell[0], cell[i]));
      twice = { twice[0] + one[0], twice[1] + one[1], twice[2] + one[2] };
    }
    return 0.5 * norm(twice) <= kMinArea * diagonal_ * diagonal_;
  }

  bool isShort(const std::array<std::int64_t, 2>& line) const
  {
    constexpr double kMinLength = 1e-7; // of the diagonal
    return norm(this->vector(line[0], line[1])) <= kMinLength * diagonal_;
  }

private:
  Point3 vector(std::int64_t from, std::int64_t to) const
  {
    return difference(centres_[from], centres_[to]);
  }

  const std::vector<Point3>& centres_;
  double diagonal_;
};

std::int64_t countZeroArea(const MedialModel& model)
{
  const Sizes sizes(model);
  const auto isFlat = [&sizes](const auto& cell) { return sizes.isFlat(cell); };
  return std::count_if(model.quads.begin(), model.quads.end(), isFlat) +
    std::count_if(model.triangles.begin(), model.triangles.end(), isFlat) +
    std::count_if(model.lines.begin(), model.lines.end(),
      [&sizes](const auto& line) { return sizes.isShort(line); });
}

template <typename T>
std::int64_t count(const std::vector<T>& values)
{
  return static_cast<std::int64_t>(values.size());
}

} // namespace

std::vector<std::array<std::int64_t, 3>> MedialModel::allTriangles() const
{
  std::vector<std::array<std::int64_t, 3>> all = triangles;
  all.reserve(triangles.size() + 2 * quads.size());
  for (const auto& quad : quads)
  {
    for (const auto& [a, b, c] :
      quadTriangles({ centres[quad[0]], centres[quad[1]], centres[quad[2]], centres[quad[3]] }))
    {
      all.push_back({ quad[a], quad[b], quad[c] });
    }
  }
  return all;
}

std::array<std::array<int, 3>, 2> quadTriangles(const std::array<Point3, 4>& corners)
{
  const auto smaller = [&corners](const std::array<std::array<int, 3>, 2>& triangles)
  {
    const auto area = [&corners](const std::array<int, 3>& triangle)
    {
      return norm(cross(difference(corners[triangle[0]], corners[triangle[1]]),
        difference(corners[triangle[0]], corners[triangle[2]])));
    };
    return std::min(area(triangles[0]), area(triangles[1]));
  };
  constexpr std::array<std::array<int, 3>, 2> kUsual{ { { 0, 1, 2 }, { 0, 2, 3 } } };
  constexpr std::array<std::array<int, 3>, 2> kOther{ { { 1, 2, 3 }, { 1, 3, 0 } } };
  return smaller(kOther) > 2.0 * smaller(kUsual) ? kOther : kUsual;
}

MedialModel toMedialModel(const MedialAxis& axis)
{
  MedialModel model;
  model.centres = axis.points;
  model.radii.assign(axis.radius.begin(), axis.radius.end());
  model.quads = axis.quads;
  model.triangles = axis.triangles;
  model.lines = axis.lines;
  model.vertices = axis.vertices;
  return model;
}

void checkMedialModel(const MedialModel& model)
{
  std::ostringstream message;
  if (model.centres.empty())
  {
    message << "the medial axis has 0 points";
    refuse(message);
  }
  if (model.radii.size() != model.centres.size())
  {
    message << model.radii.size() << " radii for " << model.centres.size() << " centres";
    refuse(message);
  }
  for (std::size_t i = 0; i < model.centres.size(); ++i)
  {
    checkBall(i, model.centres[i], model.radii[i]);
  }
  checkCells("quad", model.quads, model.centres.size());
  checkCells("triangle", model.triangles, model.centres.size());
  checkCells("line", model.lines, model.centres.size());
  std::vector<std::array<std::int64_t, 1>> vertices;
  for (const std::int64_t vertex : model.vertices)
  {
    vertices.push_back({ vertex });
  }
  checkCells("vertex", vertices, model.centres.size());
}

ModelCounts countModel(const MedialModel& model)
{
  checkMedialModel(model);
  ModelCounts counts;
  counts.points = count(model.centres);
  counts.quads = count(model.quads);
  counts.triangles = count(model.triangles);
  counts.lines = count(model.lines);
  counts.vertices = count(model.vertices);
  counts.zeroAreaCells = countZeroArea(model);
  const auto edges = distinctEdges(model);
  counts.components = countComponents(model.centres.size(), edges);
  counts.eulerCharacteristic =
    counts.points - count(edges) + count(distinct(model.triangles)) + count(distinct(model.quads));
  return counts;
}

} // namespace medial
