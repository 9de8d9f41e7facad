#include "pairs/pair_registry.h"

namespace medial::benchmark
{

const std::vector<PairMethodEntry>& availablePairMethods()
{
  constexpr PairQuestion kCollision = PairQuestion::Collision;
  constexpr PairQuestion kDepths = PairQuestion::SeparationOrDepth;
  constexpr PairQuestion kContacts = PairQuestion::Contacts;
  static const std::vector<PairMethodEntry> methods = {
    { "medial-collision", { kCollision }, [] { return makeMedialPairs(kCollision); } },
    { "medial-depths", { kDepths }, [] { return makeMedialPairs(kDepths); } },
    { kMedialAllId, { kContacts }, [] { return makeMedialPairs(kContacts); } },
#ifdef MEDIAL_HAVE_FCL_PAIRS
    { "fcl-collide", { kCollision }, [] { return makeFclPairs(kCollision); } },
    { "fcl-distance", { kDepths }, [] { return makeFclPairs(kDepths); } },
    { "fcl-contacts", { kContacts }, [] { return makeFclPairs(kContacts); } },
#endif
#ifdef MEDIAL_HAVE_ODE_PAIRS
    { "ode-one", { kCollision }, [] { return makeOdePairs(kCollision); } },
    { "ode-contacts", { kContacts }, [] { return makeOdePairs(kContacts); } },
#endif
#ifdef MEDIAL_HAVE_BULLET_PAIRS
    { "bullet", { kCollision, kContacts }, makeBulletPairs },
#endif
#ifdef MEDIAL_HAVE_CGAL_PAIRS
    { "cgal-collision", { kCollision }, [] { return makeCgalPairs(kCollision); } },
    { "cgal-depths", { kDepths }, [] { return makeCgalPairs(kDepths); } },
#endif
#ifdef MEDIAL_HAVE_VTK_PAIRS
    { "vtk-collision", { kCollision }, makeVtkPairs },
#endif
  };
  return methods;
}

const std::vector<std::string>& knownPairMethodIds()
{
  static const std::vector<std::string> ids = { "medial-collision", "medial-depths", kMedialAllId,
    "fcl-collide", "fcl-distance", "fcl-contacts", "ode-one", "ode-contacts", "bullet",
    "cgal-collision", "cgal-depths", "vtk-collision" };
  return ids;
}

} // namespace medial::benchmark
