#include "thinning/curve_probe.h"

#include "base/separation_angle.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <array>

namespace medial
{
namespace
{

constexpr double kMaxAngle = 120.0; // degrees
constexpr double kMinCosine = -0.5; // its cosine

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
  if (glm::dot(a.outwards, b.outwards) > (through ? kMinCosine : cosine))
  {
    return false;
  }
  const glm::dvec3 gap = a.closest - b.closest;
  if (!through)
  {
    // As for neighbours: otherwise both see the same reflex edge or the same patch.
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
  , cosine_(std::cos(std::min(angle, glm::radians(kMaxAngle))))
{
}

bool CurveProbe::seeOneFace(const CubicalComplex& complex, CubeCell edge) const
{
  const int axis = CubicalComplex::kind(edge) - kEdgeKind;
  const auto u = static_cast<std::size_t>(complex.stride((axis + 1) % 3));
  const auto v = static_cast<std::size_t>(complex.stride((axis + 2) % 3));
  const std::int32_t* const site = closestSites_ + CubicalComplex::index(edge);
  return sites_.kind(*site) == SiteKind::Face && *site == *(site - u) && *site == *(site - v) &&
    *site == *(site - u - v);
}

bool CurveProbe::separates(const CubicalComplex& complex, CubeCell edge) const
{
  if (this->seeOneFace(complex, edge))
  {
    return false;
  }
  const int axis = CubicalComplex::kind(edge) - kEdgeKind;
  glm::ivec3 u(0);
  glm::ivec3 v(0);
  u[(axis + 1) % 3] = 1;
  v[(axis + 2) % 3] = 1;
  const glm::ivec3 p = complex.position(edge);
  std::array<Voxel, 4> voxels;
  int count = 0;
  for (const glm::ivec3& point : { p, p - u, p - v, p - u - v })
  {
    Voxel& voxel = voxels[count];
    const std::size_t index = CubicalComplex::index(complex.cell(point, 0));
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
  for (int i = 0; i < count; ++i)
  {
    for (int j = i + 1; j < count; ++j)
    {
      if (apart(voxels[i], voxels[j], cosine_))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace medial
