#pragma once

#include "axis/axis_geometry.h"
#include "base/huge_pages.h"
#include "field/crossing.h"
#include "medial/grid.h"
#include "ranks/axis/kept_field.h"
#include "ranks/axis/sites_here.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// The field in a part of the grid, as far as crossings tell it or a rank has asked others for it
/// (KeptField).
class AskedField
{
public:
  /// @param kept must outlive this.
  /// @param sites that are here; must outlive this.
  /// @param extent the part of the grid.
  AskedField(const KeptField& kept, const SitesHere& sites, const Extent& extent);

  const Extent& extent() const { return extent_; }
  /// Takes the closest sites and the side of the ends of a crossing; their distances may have other
  /// last bits. Asks for ends so near to the surface that distances may be 0.
  void take(const AxisGeometry& geometry, const Crossing& crossing);
  /// Asks for the closest site and the side of a point, unless they are known or it is not in the
  /// part.
  void want(const glm::ivec3& point);
  /// Asks for the bits of a point of the part.
  void wantBits(const glm::ivec3& point);
  /// Brings what has been asked for. Every rank calls it.
  void bring();

  ///@{
  /// World units, and closest sites that are here; at points that are known, x fastest.
  const float* distances() const { return distances_.data(); }
  const std::int32_t* closestSites() const { return closestSites_.data(); }
  ///@}

private:
  void take(const AxisGeometry& geometry, const glm::ivec3& point, std::int32_t site, bool inside);

  const KeptField& kept_;
  const SitesHere& sites_;
  Extent extent_;
  SparseVector<float> distances_;
  SparseVector<std::int32_t> closestSites_;
  std::vector<std::uint64_t> wanted_; ///< a bit for each point
};

} // namespace medial
