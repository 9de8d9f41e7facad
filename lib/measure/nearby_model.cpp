#include "measure/nearby_model.h"

#include "balls/ball_union.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace medial
{
namespace
{

/// Tells whether cells can be near places, and numbers the balls of those that can.
class Neighbourhood
{
public:
  Neighbourhood(const MedialModel& model, const std::vector<glm::dvec3>& places, double reach)
    : model_(model)
    , places_(pointsAt(places))
    , reach_(reach)
    , kept_(model.centres.size(), 0)
  {
  }

  /// Keeps the balls that can be near.
  void keepBalls()
  {
    tbb::parallel_for(std::size_t{ 0 }, kept_.size(),
      [&](std::size_t i)
      { kept_[i] = this->isNear(std::array<std::int64_t, 1>{ std::int64_t(i) }); });
  }

  /// Returns the cells that can be near, and keeps their balls.
  template <typename Cell>
  std::vector<Cell> keepCells(const std::vector<Cell>& cells)
  {
    std::vector<char> near(cells.size());
    tbb::parallel_for(std::size_t{ 0 }, cells.size(),
      [&](std::size_t i) { near[i] = this->isNear(cells[i]); });
    std::vector<Cell> kept;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      if (near[i] != 0)
      {
        kept.push_back(cells[i]);
        for (const std::int64_t ball : cells[i])
        {
          kept_[ball] = 1;
        }
      }
    }
    return kept;
  }

  /// Returns a model of the balls that are kept, and of cells of these.
  MedialModel model(MedialModel cells) const
  {
    std::vector<std::int64_t> numbers(kept_.size(), -1);
    for (std::size_t i = 0; i < kept_.size(); ++i)
    {
      if (kept_[i] != 0)
      {
        numbers[i] = static_cast<std::int64_t>(cells.centres.size());
        cells.centres.push_back(model_.centres[i]);
        cells.radii.push_back(model_.radii[i]);
      }
    }
    const auto renumber = [&](auto& some)
    {
      for (auto& cell : some)
      {
        std::transform(cell.begin(), cell.end(), cell.begin(),
          [&](std::int64_t ball) { return numbers[ball]; });
      }
    };
    renumber(cells.quads);
    renumber(cells.triangles);
    renumber(cells.lines);
    return cells;
  }

private:
  static std::vector<Ball> pointsAt(const std::vector<glm::dvec3>& places)
  {
    std::vector<Ball> points;
    points.reserve(places.size());
    for (const glm::dvec3& place : places)
    {
      points.push_back({ place, 0.0 });
    }
    return points;
  }

  glm::dvec3 centre(std::int64_t ball) const
  {
    const Point3& x = model_.centres[ball];
    return { x[0], x[1], x[2] };
  }

  /// Whether a ball around the first centre that holds the hull of a cell's balls is near a place.
  template <typename Cell>
  bool isNear(const Cell& cell) const
  {
    constexpr double kRounding = 1.0 + 1e-9;
    const glm::dvec3 x = this->centre(cell[0]);
    double radius = 0.0;
    for (const std::int64_t ball : cell)
    {
      radius = std::max(radius, glm::distance(x, this->centre(ball)) + model_.radii[ball]);
    }
    return places_.covers(x, -(radius + reach_) * kRounding);
  }

  const MedialModel& model_;
  BallUnion places_;
  double reach_;
  std::vector<char> kept_; ///< per ball
};

} // namespace

MedialModel modelNear(const MedialModel& model, bool interpolate,
  const std::vector<glm::dvec3>& places, double reach)
{
  MedialModel cells;
  if (places.empty())
  {
    return cells;
  }
  Neighbourhood near(model, places, reach);
  near.keepBalls();
  if (interpolate)
  {
    cells.quads = near.keepCells(model.quads);
    cells.triangles = near.keepCells(model.triangles);
    cells.lines = near.keepCells(model.lines);
  }
  return near.model(std::move(cells));
}

} // namespace medial
