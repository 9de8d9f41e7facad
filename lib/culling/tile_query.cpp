#include "medial/culling/tile_query.h"

#include <algorithm>
#include <limits>

namespace medial
{

TileQuery::TileQuery(const SiteSet& sites, const CandidateFilter& filter, const GridFrame& frame,
  const Extent& extent, const glm::ivec3& tileSize)
  : sites_(sites)
  , filter_(filter)
  , frame_(frame)
  , extent_(extent)
  , tileSize_(tileSize)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    tileCounts_[axis] = (extent.size(axis) + tileSize[axis] - 1) / tileSize[axis];
  }
  tiles_.resize(static_cast<std::size_t>(tileCounts_.x) * tileCounts_.y * tileCounts_.z);
}

std::size_t TileQuery::tileIndex(const glm::ivec3& gridPoint) const
{
  std::size_t index = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const int offset = gridPoint[axis] - extent_.min[axis];
    index = index * tileCounts_[axis] + offset / tileSize_[axis];
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

SitePoint TileQuery::closest(const glm::dvec3& x, double knownDistance) const
{
  // Grid points belong to their own tile, whatever the rounding of their position.
  constexpr double kRounding = 1e-6;
  const glm::dvec3 cell = glm::floor((x - frame_.first) / frame_.step + kRounding);
  glm::ivec3 gridPoint;
  for (int axis = 0; axis < 3; ++axis)
  {
    gridPoint[axis] =
      std::clamp(static_cast<int>(cell[axis]), extent_.min[axis], extent_.max[axis]);
  }
  const Candidates& candidates = tiles_[this->tileIndex(gridPoint)];
  const glm::vec3 rounded(x);
  const float tolerance = 2.0f * filter_.slack();
  constexpr auto kFarthest = static_cast<double>(std::numeric_limits<float>::max());
  float limit = static_cast<float>(std::min(knownDistance, kFarthest)) + tolerance;
  SitePoint best;
  double least = std::numeric_limits<double>::max();
  for (const int* site = candidates.begin; site != candidates.end; ++site)
  {
    const glm::vec4& sphere = sites_.sphere(*site);
    const glm::vec3 toCentre = rounded - glm::vec3(sphere);
    const float reach = limit + sphere.w;
    if (glm::dot(toCentre, toCentre) > reach * reach ||
      filter_.bounds(*site, rounded).lower > limit)
    {
      continue;
    }
    const SitePoint candidate = closestPoint(sites_, *site, x);
    const double distance = glm::distance(candidate.point, x);
    if (distance < least)
    {
      least = distance;
      limit = std::min(limit, static_cast<float>(distance) + tolerance);
      best = candidate;
    }
  }
  return best;
}

} // namespace medial
