#include "ranks/axis/asked_field.h"

#include "base/extents.h"
#include "ranks/field/field_part.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <cstddef>

namespace medial
{
namespace
{

constexpr std::size_t kWord = 64;

/// Farther from the surface no distance is rounded to 0, which is on no side; local units.
constexpr double kSure = 0.01;

} // namespace

AskedField::AskedField(const KeptField& kept, const SitesHere& sites, const Extent& extent)
  : kept_(kept)
  , sites_(sites)
  , extent_(extent)
  , distances_(static_cast<std::size_t>(extent.pointCount()))
  , closestSites_(distances_.size())
  , wanted_((distances_.size() + kWord - 1) / kWord)
{
}

void AskedField::take(const AxisGeometry& geometry, const Crossing& crossing)
{
  glm::ivec3 end = crossing.voxel;
  ++end[crossing.axis];
  this->take(geometry, crossing.voxel, crossing.siteA, crossing.inside);
  this->take(geometry, end, crossing.siteB, crossing.inside);
}

void AskedField::take(const AxisGeometry& geometry, const glm::ivec3& point, std::int32_t site,
  bool inside)
{
  if (!hasPoint(extent_, point))
  {
    return;
  }
  const glm::dvec3 x = geometry.frame.sample(glm::dvec3(point));
  const double distance = glm::distance(closestPoint(geometry.sites, site, x).point, x);
  if (distance < kSure)
  {
    this->wantBits(point);
    return;
  }
  const std::size_t i = pointIndex(extent_, point);
  distances_[i] = static_cast<float>((inside ? -distance : distance) * geometry.frame.unit);
  closestSites_[i] = site;
}

void AskedField::want(const glm::ivec3& point)
{
  // Those on the surface are asked for again.
  if (hasPoint(extent_, point) && distances_[pointIndex(extent_, point)] == 0.0f)
  {
    this->wantBits(point);
  }
}

void AskedField::wantBits(const glm::ivec3& point)
{
  const std::size_t i = pointIndex(extent_, point);
  wanted_[i / kWord] |= std::uint64_t{ 1 } << (i % kWord);
}

void AskedField::bring()
{
  std::vector<std::size_t> points;
  std::vector<std::int64_t> numbers;
  for (std::size_t word = 0; word < wanted_.size(); ++word)
  {
    for (; wanted_[word] != 0; wanted_[word] &= wanted_[word] - 1)
    {
      points.push_back(kWord * word + static_cast<std::size_t>(__builtin_ctzll(wanted_[word])));
      numbers.push_back(kept_.numbers().of(pointAt(extent_, points.back())));
    }
  }
  const std::vector<FieldValue> values = kept_.at(numbers);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    distances_[points[i]] = values[i].distance;
    // Not here if the side does not need it.
    closestSites_[points[i]] = std::max(0, sites_.find(values[i].site));
  }
}

} // namespace medial
