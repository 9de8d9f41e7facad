#pragma once

#include "field/tile_field.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Finds closest sites by evaluating every candidate of a tile at the tile's grid points: what a
/// processor does faster than it can imitate a rasteriser. As there, distance vectors are affine
/// (the paper's section 3.1) and evaluated only where the site's bounds let them win.
///
/// Edges compete where the point projects into them and vertices everywhere, whatever the other
/// half-spaces say, so that rounding leaves no gaps between sites.
class TileEvaluator
{
public:
  /// @param normals pseudonormals of all sites, for the sign.
  TileEvaluator(const SiteSet& sites, const std::vector<glm::vec4>& normals, const GridFrame& frame,
    float slack);

  /// @param tile no longer than TileField::kRow.
  /// @param candidates all of the tile's, `count` of them, ascending.
  /// @return number of pairs of grid points and sites that were evaluated.
  std::int64_t evaluate(const Extent& tile, const int* candidates, std::size_t count,
    TileField& field) const;

  /// Vector from a point to the closest point of the site that evaluate() found for it; frame
  /// units.
  glm::dvec3 displacement(int site, const glm::dvec3& x) const;

private:
  /// The half-spaces of a face in double precision; the last two only matter for needles.
  struct FaceSides
  {
    glm::dvec4 side[5];
    int count;
  };

  void setFaceSides(int face);
  /// Exact queries where no candidate's bounds hold a point. There should be no such point; this
  /// makes sure of it.
  void fillHoles(const Extent& extent, const int* candidates, std::size_t count,
    TileField& field) const;

  const SiteSet& sites_;
  const std::vector<glm::vec4>& normals_;
  GridFrame frame_;
  float slack_;
  std::vector<FaceSides> faceSides_;
};

} // namespace medial
