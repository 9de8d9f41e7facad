#include "culling/tile_query.h"

#include "medial/memory.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>

namespace medial
{
namespace
{

constexpr int kTileSize = CandidateHierarchy::kLeafSize;

} // namespace

TileQuery::TileQuery(const SiteSet& sites, const CandidateFilter& filter, const GridFrame& frame,
  const Extent& extent)
  : sites_(sites)
  , filter_(filter)
  , frame_(frame)
  , extent_(extent)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    tileCounts_[axis] = (extent.size(axis) + kTileSize - 1) / kTileSize;
  }
  const std::size_t tiles = static_cast<std::size_t>(tileCounts_.x) * tileCounts_.y * tileCounts_.z;
  requireMemory("a table of " + std::to_string(tiles) + " tiles of the grid",
    tiles * sizeof(Candidates));
  tiles_.resize(tiles);
}

std::size_t TileQuery::tileIndex(const glm::ivec3& gridPoint) const
{
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int offset = gridPoint[axis] - extent_.min[axis];
    index = index * tileCounts_[axis] + offset / kTileSize;
  }
  return index;
}

void TileQuery::add(CandidateTiles tiles)
{
  blocks_.push_back(std::move(tiles));
  const CandidateTiles& block = blocks_.back();
  for (std::size_t t = 0; t < block.tiles.size(); ++t)
  {
    const std::array<int, 3>& corner = block.tiles[t].min;
    const int* candidates = block.candidates.data();
    tiles_[this->tileIndex({ corner[0], corner[1], corner[2] })] = { candidates + block.offsets[t],
      candidates + block.offsets[t + 1] };
  }
}

std::size_t TileQuery::tileAround(const glm::dvec3& x) const
{
  // Grid points belong to their own tile, even if their position is rounded.
  constexpr double kRounding = 1e-6;
  const glm::dvec3 cell = glm::floor((x - frame_.first) / frame_.step + kRounding);
  glm::ivec3 gridPoint;
  for (int axis = 0; axis < 3; ++axis)
  {
    gridPoint[axis] =
      std::clamp(static_cast<int>(cell[axis]), extent_.min[axis], extent_.max[axis]);
  }
  return this->tileIndex(gridPoint);
}

void TileQuery::closestInTile(const Candidates& tile, Question* const* questions, int count,
  std::vector<NearSite>& scratch) const
{
  constexpr auto kUnknown = static_cast<double>(std::numeric_limits<float>::max());
  std::array<double, PointLanes::kMax> min;
  PointLanes lanes;
  lanes.count = count;
  for (int i = 0; i < PointLanes::kMax; ++i)
  {
    const Question& question = *questions[i < count ? i : 0];
    const bool known = question.closest.site >= 0;
    min[i] = known ? glm::distance(question.x, question.closest.point) : kUnknown;
    lanes.x[i] = static_cast<float>(question.x.x);
    lanes.y[i] = static_cast<float>(question.x.y);
    lanes.z[i] = static_cast<float>(question.x.z);
    lanes.reach[i] =
      static_cast<float>(known ? min[i] + 2.0 * static_cast<double>(filter_.slack()) : kUnknown);
  }
  scratch.reserve(tile.end - tile.begin);
  filter_.near(tile.begin, tile.end, lanes, scratch);
  for (const NearSite& near : scratch)
  {
    for (unsigned left = near.points; left != 0; left &= left - 1)
    {
      const int i = __builtin_ctz(left);
      Question& question = *questions[i];
      if (question.closest.site == near.site)
      {
        continue;
      }
      const SitePoint candidate = closestPoint(sites_, near.site, question.x);
      const double distance = glm::distance(candidate.point, question.x);
      if (distance < min[i])
      {
        min[i] = distance;
        question.closest = candidate;
      }
    }
  }
}

SitePoint TileQuery::closest(const glm::dvec3& x, const SitePoint& known) const
{
  thread_local std::vector<NearSite> scratch;
  Question question{ x, known };
  Question* const only = &question;
  this->closestInTile(tiles_[this->tileAround(x)], &only, 1, scratch);
  return question.closest;
}

void TileQuery::closest(std::vector<Question>& questions) const
{
  std::vector<std::pair<std::size_t, Question*>> order;
  order.reserve(questions.size());
  for (Question& question : questions)
  {
    order.emplace_back(this->tileAround(question.x), &question);
  }
  std::sort(order.begin(), order.end());
  std::vector<NearSite> scratch;
  std::array<Question*, PointLanes::kMax> together;
  for (auto next = order.begin(); next != order.end();)
  {
    const std::size_t tile = next->first;
    int count = 0;
    while (count < PointLanes::kMax && next != order.end() && next->first == tile)
    {
      together[count++] = (next++)->second;
    }
    this->closestInTile(tiles_[tile], together.data(), count, scratch);
  }
}

} // namespace medial
