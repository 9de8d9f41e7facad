#pragma once

#include "culling/group_tree.h"
#include "sites/closest_point.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// Finds exact closest surface points, in double precision, at any position; of several at the same
/// distance that of the lowest site. From positions out of reach, where rounding makes most of the
/// surface equally far, it finds one that is closest up to this rounding. Several threads may query
/// it at once.
class SiteQuery
{
public:
  /// @param tree must outlive this.
  explicit SiteQuery(const GroupTree& tree);

  /// Returns the closest surface point.
  /// @param x local coordinates.
  /// @param known start of the search: the closest point of some site to x. The nearer it is, the
  ///   faster the search; the answer does not depend on it. A site of -1 means none.
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
    /// A site that need not be tried: it is no nearer than the known point, nor as near and lower.
    int other = -1;
  };
  /// The same for many positions, much faster if they lie close together.
  void closest(std::vector<Question>& questions) const;

  /// Whether a position is a number near enough for single precision.
  static bool inReach(const glm::dvec3& x);

private:
  /// @param bound some surface point is no farther away.
  /// @param limit surface points at this distance or beyond do not count.
  SitePoint search(const glm::dvec3& x, double bound, double limit) const;
  /// The same for positions out of reach.
  SitePoint searchFromAfar(const glm::dvec3& x, double limit) const;

  const GroupTree& tree_;
};

} // namespace medial
