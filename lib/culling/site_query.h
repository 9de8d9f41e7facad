#pragma once

#include "culling/group_tree.h"
#include "sites/closest_point.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Finds exact closest surface points, in double precision, at any position; of several at the same
/// distance that of the lowest site. Several threads may query it at once.
class SiteQuery
{
public:
  /// @param tree must outlive this.
  explicit SiteQuery(const GroupTree& tree);

  /// Returns the closest surface point.
  /// @param x local coordinates.
  /// @param known start of the search: the closest point of some site to x. The nearer it is, the
  ///   faster the search. It is returned if no other point is nearer. A site of -1 means none.
  SitePoint closest(const glm::dvec3& x, const SitePoint& known = {}) const;

  /// Returns the closest surface point; its site is -1 if there is none within the limit, or if x
  /// is not a number.
  /// @param limit local units; surface points at this distance or beyond do not count.
  SitePoint closestWithin(const glm::dvec3& x, double limit) const;

  /// A position with a known point, which closest() replaces by the closest one.
  struct Question
  {
    glm::dvec3 x;
    SitePoint closest;
  };
  /// The same for many positions.
  void closest(std::vector<Question>& questions) const;

private:
  SitePoint search(const glm::dvec3& x, SitePoint closest, double distance) const;

  const GroupTree& tree_;
};

} // namespace medial
