#include "medial/culling/half_space_packs.h"

#include <limits>

namespace medial
{
namespace
{

PlanePack emptyPack()
{
  PlanePack pack{};
  for (int lane = 0; lane < PlanePack::kLanes; ++lane)
  {
    pack.offset[lane] = std::numeric_limits<float>::max();
  }
  return pack;
}

} // namespace

void PlanePack::set(int lane, const HalfSpace& plane)
{
  x[lane] = plane.x;
  y[lane] = plane.y;
  z[lane] = plane.z;
  offset[lane] = plane.w;
}

HalfSpacePacks::HalfSpacePacks(const SiteSet& sites)
{
  offsets_.reserve(sites.size() + 1);
  for (int site = 0; site < sites.size(); ++site)
  {
    int lane = PlanePack::kLanes;
    const HalfSpace* end = sites.halfSpacesEnd(site);
    for (const HalfSpace* plane = sites.halfSpacesBegin(site); plane != end; ++plane)
    {
      if (lane == PlanePack::kLanes)
      {
        packs_.push_back(emptyPack());
        lane = 0;
      }
      packs_.back().set(lane++, *plane);
    }
    offsets_.push_back(static_cast<int>(packs_.size()));
  }
}

} // namespace medial
