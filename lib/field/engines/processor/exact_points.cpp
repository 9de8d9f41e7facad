#include "field/engines/processor/exact_points.h"

#include <glm/glm.hpp>

namespace medial
{
namespace
{

/// Whether functions over a tile have large values wherever its sites are.
bool isLong(const Extent& tile, const glm::dvec3& step)
{
  const glm::dvec3 cells(tile.size(0) - 1, tile.size(1) - 1, tile.size(2) - 1);
  const glm::dvec3 diagonal = cells * step;
  return glm::dot(diagonal, diagonal) > static_cast<double>(TileField::kFarSquared);
}

} // namespace

ExactPoints::ExactPoints(const SiteQuery& query, const GridFrame& frame)
  : query_(query)
  , frame_(frame)
{
}

bool ExactPoints::fill(const Extent& tile, const SliceRange& slices, TileField& field) const
{
  const bool all = isLong(tile, frame_.step);
  bool filled = false;
  for (int k = slices.begin; k < slices.end; ++k)
  {
    for (int j = 0; j < tile.size(1); ++j)
    {
      for (int i = 0; i < tile.size(0); ++i)
      {
        const int index = TileField::index(i, j, k);
        if (!all && field.site[index] >= 0 && field.squared[index] <= TileField::kFarSquared)
        {
          continue;
        }
        const glm::dvec3 x =
          frame_.sample(glm::dvec3(tile.min[0] + i, tile.min[1] + j, tile.min[2] + k));
        const SitePoint closest = query_.closest(x);
        field.squared[index] = static_cast<float>(glm::dot(closest.point - x, closest.point - x));
        field.site[index] = closest.site;
        filled = true;
      }
    }
  }
  return filled;
}

} // namespace medial
