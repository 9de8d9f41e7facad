#include "medial/medial/topology/curve_probe.h"

#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <algorithm>
#include <array>

namespace medial
{
namespace
{

constexpr double kMostAngle = 120.0; // degrees

struct Voxel
{
  glm::dvec3 place;
  glm::dvec3 closest;
  glm::dvec3 outwards; ///< unit vector, through `closest`
  bool inside;
};

bool apart(const Voxel& a, const Voxel& b, double cosine)
{
  const bool through = !a.inside || !b.inside;
  if (glm::dot(a.outwards, b.outwards) > (through ? std::cos(glm::radians(kMostAngle)) : cosine))
  {
    return false;
  }
  const glm::dvec3 gap = a.closest - b.closest;
  if (!through)
  {
    // As for neighbours: else both see one reflex edge or the same patch.
    const glm::dvec3 step = a.place - b.place;
    return glm::dot(gap, gap) >= glm::dot(step, step);
  }
  return glm::dot(gap, a.outwards - b.outwards) > 0.0;
}

} // namespace

CurveProbe::CurveProbe(const SiteSet& sites, const GridFrame& frame,
  const std::int32_t* closestSites, const DepthField& depth, double angle)
  : sites_(sites)
  , frame_(frame)
  , closestSites_(closestSites)
  , depth_(depth)
  , angle_(std::min(angle, glm::radians(kMostAngle)))
{
}

bool CurveProbe::separates(const CellLattice& lattice, Cell edge) const
{
  const int axis = CellLattice::kind(edge) - kEdgeKind;
  glm::ivec3 u(0);
  glm::ivec3 v(0);
  u[(axis + 1) % 3] = 1;
  v[(axis + 2) % 3] = 1;
  const glm::ivec3 p = lattice.position(edge);
  std::array<Voxel, 4> voxels;
  int count = 0;
  for (const glm::ivec3& point : { p, p - u, p - v, p - u - v })
  {
    Voxel& voxel = voxels[count];
    const std::size_t index = CellLattice::index(lattice.cell(point, 0));
    voxel.place = frame_.sample(glm::dvec3(point));
    voxel.closest = closestPoint(sites_, closestSites_[index], voxel.place).point;
    voxel.inside = depth_.wanted(index);
    const glm::dvec3 way = voxel.inside ? voxel.closest - voxel.place : voxel.place - voxel.closest;
    const double length = glm::length(way);
    if (length > 0.0)
    {
      voxel.outwards = way / length;
      ++count;
    }
  }
  const double cosine = std::cos(angle_);
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 1; j < count; ++j)
    {
      if (apart(voxels[i], voxels[j], cosine))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace medial
