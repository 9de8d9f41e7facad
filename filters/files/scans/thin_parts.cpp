#include "files/scans/thin_parts.h"

#include <cstddef>

namespace medial::files
{
namespace
{

using Voxel = ThinParts::Voxel;

// Whether something holds for one of the voxels of a block at least.
template <typename Holds>
bool anyIn(const Voxel& first, int size, const Holds& holds)
{
  for (int z = 0; z < size; ++z)
  {
    for (int y = 0; y < size; ++y)
    {
      for (int x = 0; x < size; ++x)
      {
        if (holds(Voxel{ first[0] + x, first[1] + y, first[2] + z }))
        {
          return true;
        }
      }
    }
  }
  return false;
}

} // namespace

ThinParts::ThinParts(const unsigned char* mask, const std::array<int, 3>& size)
  : mask_(mask)
  , size_(size)
{
}

bool ThinParts::contains(const Voxel& voxel) const
{
  const bool inside = this->isInside(voxel);
  return this->isThin(voxel) &&
    (this->isAlone(voxel) ||
      anyIn({ voxel[0] - 1, voxel[1] - 1, voxel[2] - 1 }, 3,
        [&](const Voxel& other)
        { return this->isInside(other) == inside && this->isAlone(other); }));
}

bool ThinParts::isInside(const Voxel& voxel) const
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (voxel[axis] < 0 || voxel[axis] >= size_[axis])
    {
      return false;
    }
  }
  const std::size_t row = static_cast<std::size_t>(voxel[2]) * size_[1] + voxel[1];
  return mask_[row * size_[0] + voxel[0]] != 0;
}

bool ThinParts::isThin(const Voxel& voxel) const
{
  const bool inside = this->isInside(voxel);
  const auto isOther = [&](const Voxel& other) { return this->isInside(other) != inside; };
  return !anyIn({ voxel[0] - 1, voxel[1] - 1, voxel[2] - 1 }, 2,
    [&](const Voxel& block) { return !anyIn(block, 2, isOther); });
}

bool ThinParts::isAlone(const Voxel& voxel) const
{
  if (!this->isThin(voxel))
  {
    return false;
  }
  const bool inside = this->isInside(voxel);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (const int step : { -1, 1 })
    {
      Voxel beside = voxel;
      beside[axis] += step;
      if (this->isInside(beside) == inside && !this->isThin(beside))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace medial::files
