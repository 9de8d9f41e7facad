#include "field/field_writer.h"

#include "base/extents.h"
#include "sites/closest_point.h"

#include <glm/gtc/type_ptr.hpp>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace medial
{
namespace
{

void storePoint(const Point3& point, float* target)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    target[axis] = static_cast<float>(point[axis]);
  }
}

} // namespace

FieldWriter::FieldWriter(const FieldJob& job, const InsideRows* inside)
  : host_(job.host)
  , cells_(job.mesh, job.connectivity)
  , frame_(job.frame)
  , signed_(job.sign != FieldSign::None)
  , inside_(inside)
{
}

void FieldWriter::begin(const Extent& slab, const FieldArrays& arrays)
{
  slab_ = slab;
  arrays_ = arrays;
}

void FieldWriter::store(const ResolvedSlab& values) const
{
  if (!arrays_.any())
  {
    return;
  }
  const int rowLength = slab_.size(0);
  const std::int64_t rows = static_cast<std::int64_t>(slab_.size(1)) * slab_.size(2);
  tbb::parallel_for(std::int64_t{ 0 }, rows,
    [&](std::int64_t row)
    {
      const auto slice = static_cast<int>(row / slab_.size(1));
      const glm::ivec3 first(slab_.min[0],
        slab_.min[1] + static_cast<int>(row - static_cast<std::int64_t>(slice) * slab_.size(1)),
        slab_.min[2] + slice);
      const std::int64_t start = row * rowLength;
      if (arrays_.distance)
      {
        this->storeDistances(values.distances, start, first);
      }
      for (std::int64_t i = start; arrays_.closestPoint && i < start + rowLength; ++i)
      {
        const glm::dvec3 sample =
          frame_.sample(glm::dvec3(first) + glm::dvec3(static_cast<double>(i - start), 0.0, 0.0));
        storePoint(frame_.toWorld(sample + glm::dvec3(glm::make_vec3(values.vectors.at(i)))),
          arrays_.closestPoint + 3 * i);
      }
      if (values.sites != nullptr)
      {
        this->storeIds(start, rowLength, values.sites + start);
      }
    });
}

void FieldWriter::storeDistances(const StridedValues& distances, std::int64_t start,
  const glm::ivec3& first) const
{
  const int count = slab_.size(0);
  const double unit = frame_.unit;
  const float* from = distances.at(start);
  float* to = arrays_.distance + start;
  const auto convert = [&](std::ptrdiff_t stride)
  {
    for (int i = 0; i < count; ++i)
    {
      to[i] = static_cast<float>(static_cast<double>(from[i * stride]) * unit);
    }
  };
  // A loop of its own for values side by side, which compilers turn into vector instructions.
  if (distances.stride == 1)
  {
    convert(1);
  }
  else
  {
    convert(distances.stride);
  }
  if (inside_ != nullptr)
  {
    std::vector<float> sides(count);
    inside_->write(first, count, sides.data());
    for (int i = 0; i < count; ++i)
    {
      to[i] *= sides[i];
    }
  }
}

void FieldWriter::store(const Extent& tile, const TileField& field) const
{
  const Extent part = commonPart(tile, slab_);
  for (int k = part.min[2]; k <= part.max[2]; ++k)
  {
    for (int j = part.min[1]; j <= part.max[1]; ++j)
    {
      const glm::ivec3 first(part.min[0], j, k);
      const std::int64_t target =
        (static_cast<std::int64_t>(k - slab_.min[2]) * slab_.size(1) + (j - slab_.min[1])) *
          slab_.size(0) +
        (first.x - slab_.min[0]);
      const int row = TileField::index(first.x - tile.min[0], j - tile.min[1], k - tile.min[2]);
      this->storeDistances(target, first, part.size(0), field, row);
      this->storeClosestPoints(target, first, part.size(0), field.site + row);
      this->storeIds(target, part.size(0), field.site + row);
    }
  }
}

double FieldWriter::exactDistance(const glm::ivec3& gridPoint, std::int32_t site) const
{
  const glm::dvec3 sample = frame_.sample(glm::dvec3(gridPoint));
  return glm::distance(closestPoint(host_.sites(), site, sample).point, sample) * frame_.unit;
}

void FieldWriter::storeDistances(std::int64_t target, const glm::ivec3& first, int count,
  const TileField& field, int row) const
{
  if (!arrays_.distance)
  {
    return;
  }
  const auto set = [&](int i, double distance)
  {
    const auto rounded = static_cast<float>(distance);
    arrays_.distance[target + i] = signed_ && field.side[row + i] < 0.0f ? -rounded : rounded;
  };
  const float* squared = field.squared + row;
  for (int i = 0; i < count; ++i)
  {
    set(i, static_cast<double>(std::sqrt(squared[i])) * frame_.unit);
  }
  if (*std::max_element(squared, squared + count) > TileField::kFarSquared)
  {
    for (int i = 0; i < count; ++i)
    {
      // Whatever the points beside it, which may lie in another part of the grid.
      if (squared[i] > TileField::kFarSquared)
      {
        set(i, this->exactDistance(first + glm::ivec3(i, 0, 0), field.site[row + i]));
      }
    }
  }
}

void FieldWriter::storeClosestPoints(std::int64_t target, const glm::ivec3& first, int count,
  const std::int32_t* closest) const
{
  if (!arrays_.closestPoint)
  {
    return;
  }
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 sample = frame_.sample(glm::dvec3(first) + glm::dvec3(i, 0.0, 0.0));
    storePoint(frame_.toWorld(closestPoint(host_.sites(), closest[i], sample).point),
      arrays_.closestPoint + 3 * (target + i));
  }
}

void FieldWriter::storeIds(std::int64_t target, int count, const std::int32_t* closest) const
{
  if (arrays_.closestSite)
  {
    std::copy_n(closest, count, arrays_.closestSite + target);
  }
  if (arrays_.closestFeature)
  {
    for (int i = 0; i < count; ++i)
    {
      arrays_.closestFeature[target + i] = static_cast<std::uint8_t>(cells_.featureOf(closest[i]));
    }
  }
  if (arrays_.closestCell)
  {
    for (int i = 0; i < count; ++i)
    {
      arrays_.closestCell[target + i] = cells_.cellOf(closest[i]);
    }
  }
}

} // namespace medial
