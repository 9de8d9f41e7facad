#pragma once

#include "medial/proximity.h"
#include "proximity/contacts.h"
#include "proximity/intersections.h"
#include "proximity/moving_mesh.h"
#include "proximity/penetration.h"
#include "proximity/separation.h"
#include "proximity/solid_query.h"
#include "proximity/translational_depth.h"

#include <vector>

namespace medial
{

/// Computes how two meshes lie to each other, and keeps what the next frame can use.
class PairProximity
{
public:
  PairProximity(const MovingMesh& a, const MovingMesh& b, const SolidQuery& solidA,
    const SolidQuery& solidB);

  /// Uses the threads of the current arena.
  /// @param result that of meshes that are not known to collide.
  void compute(const ProximityOptions& options, Proximity& result);

private:
  void separate(Proximity& result);
  void meet(Proximity& result);
  void penetrate(const ProximityOptions& options, Proximity& result);
  /// Lists directions along which A may leave B.
  void listDirections(const DeepPlace& deepest);

  const MovingMesh& a_;
  const MovingMesh& b_;
  Intersections intersections_;
  Separation separation_;
  Penetration aInB_;
  Penetration bInA_;
  Contacts contacts_;
  TranslationalDepth translationalDepth_;
  std::vector<glm::dvec3> directions_;
  std::vector<int> cutA_;
  std::vector<int> cutB_;
  std::vector<CutPlace> crossings_[2]; ///< on A and on B
};

} // namespace medial
