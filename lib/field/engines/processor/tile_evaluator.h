#pragma once

#include "base/lazy_table.h"
#include "field/tile_field.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"
#include "sites/site_bounds.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// The half-spaces of a face in double precision; the last two only matter for needles.
struct FaceSides
{
  glm::dvec4 side[5];
  int count;
};

/// Finds closest sites by evaluating the candidates of a tile at its grid points, which a processor
/// does faster than imitating a rasteriser. As there, distance vectors are affine (section 3.1 of
/// the paper), and a candidate is evaluated only where the bounds of its Voronoi region allow it to
/// be closest.
///
/// To leave no gaps between sites after rounding, edges compete wherever the point projects into
/// them, and vertices everywhere, whatever their other half-spaces say.
class TileEvaluator
{
public:
  /// @param normals pseudonormals of all sites, for the sign; empty if there are no sides to find.
  /// @param bounds of all candidates.
  TileEvaluator(const SiteSet& sites, const SiteBounds& bounds,
    const std::vector<glm::vec4>& normals, const GridFrame& frame, float slack);

  /// Finds the closest sites of a tile.
  /// @param tile at most TileField::kRow points long.
  /// @param candidates all `count` candidates of the tile, ascending.
  /// @param slices of the tile to evaluate. Their values do not depend on which these are.
  /// @return number of pairs of a grid point and a site that were evaluated.
  std::int64_t evaluate(const Extent& tile, const int* candidates, std::size_t count,
    const SliceRange& slices, TileField& field) const;

  /// Sets on which side of their sites the points of a tile are.
  void setSides(const Extent& tile, const SliceRange& slices, TileField& field) const;

  /// Returns the vector from a point to the closest point of the site that evaluate() found for it;
  /// local units.
  glm::dvec3 displacement(int site, const glm::dvec3& x) const;

private:
  FaceSides sidesOf(int face) const;
  std::int64_t evaluatePrepared(const Extent& tile, const int* candidates, std::size_t count,
    const SliceRange& slices, TileField& field) const;

  const SiteSet& sites_;
  const SiteBounds& bounds_;
  const std::vector<glm::vec4>& normals_;
  GridFrame frame_;
  float slack_;
  LazyTable<FaceSides> faceSides_;
};

} // namespace medial
