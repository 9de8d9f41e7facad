#pragma once

#include "medial/proximity.h"
#include "proximity/contact_manifolds.h"
#include "proximity/contact_reduction.h"
#include "proximity/intersections.h"
#include "proximity/penetration.h"
#include "proximity/solid_query.h"
#include "proximity/touching_normal.h"

#include <vector>

namespace medial
{

/// Finds the contacts of two meshes that collide.
///
/// Places of contact are the points of one mesh inside the other, with the direction to the closest
/// point (the gradient of the paper's distance field) as normal, and the crossings of edges with
/// faces. Seen along the manifold's normal only the corners of their convex hull matter.
class Contacts
{
public:
  Contacts(const MovingMesh& a, const MovingMesh& b, const SolidQuery& solidA,
    const SolidQuery& solidB)
    : a_(a)
    , b_(b)
    , solidA_(solidA)
    , solidB_(solidB)
  {
  }

  /// @param deepest the deepest place of either surface.
  /// @param maxContacts of a manifold, >= 1.
  void find(const Intersections& intersections, const Penetration& aInB, const Penetration& bInA,
    const DeepPlace& deepest, int maxContacts, std::vector<ProximityContact>& contacts);

private:
  /// A connected overlap.
  struct Manifold
  {
    std::vector<ContactPlace> places;
    std::vector<SlotPair> pairs;
    std::vector<SlotPair> uncrossed; ///< those without crossings
    glm::dvec3 normal{ 0.0 };
  };

  void collect(const Intersections& intersections, const Penetration& aInB, const Penetration& bInA,
    const DeepPlace& deepest);
  void addPlace(const DeepPlace& found, int manifold);
  /// The unit direction from a place to the other surface.
  glm::dvec3 wayOut(const DeepPlace& place) const;
  void reduce(Manifold& manifold, int maxContacts);
  /// Drops crossings where the overlap has no depth.
  /// @param max the largest depth of the manifold's places, > 0.
  void weighCrossings(Manifold& manifold, double extent, double max) const;
  /// Returns the normal of a manifold. Where the surfaces only touch, places lose theirs, and the
  /// corners of what elements in one plane share are added.
  glm::dvec3 findNormal(Manifold& manifold);
  /// Adds where pairs of elements without crossings touch: corners on the other, and edges.
  void addTouches(Manifold& manifold) const;
  /// How thick the overlap of both solids is along the line through a position.
  /// @param step how far along that line to look for the overlap.
  double thicknessAt(const glm::dvec3& x, const glm::dvec3& normal, double step) const;

  const MovingMesh& a_;
  const MovingMesh& b_;
  const SolidQuery& solidA_;
  const SolidQuery& solidB_;
  ContactManifolds split_;
  std::vector<Manifold> manifolds_; ///< more than there are: they keep their memory
  ContactReduction reduction_;
  TouchingNormal touchingNormal_;
  double rounding_ = 0.0;           ///< of coordinates, in world units
  std::vector<ContactPlace> known_; ///< places of a manifold whose depth is known
};

} // namespace medial
