#include "thinning/solid_bodies.h"

#include "base/disjoint_sets.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace medial
{
namespace
{

/// If the balls around two neighbours overlap by less than this share of their distance, there is
/// room between them for a surface that they touch.
constexpr double kOverlap = 1e-3;

using Pair = std::pair<int, int>;

/// Connected parts of a surface.
struct SurfaceParts
{
  std::vector<int> ofSite;
  std::vector<double> volumes;

  int count() const { return static_cast<int>(volumes.size()); }
};

SurfaceParts partsOf(const SiteSet& sites, const std::vector<std::int8_t>& directions)
{
  DisjointSets joined(sites.points().size());
  for (const glm::ivec2& edge : sites.edges())
  {
    joined.join(edge.x, edge.y);
  }
  SurfaceParts parts;
  std::vector<int> partOfPoint(sites.points().size());
  for (std::size_t p = 0; p < partOfPoint.size(); ++p)
  {
    const auto lowest = static_cast<std::size_t>(joined.find(static_cast<std::int64_t>(p)));
    partOfPoint[p] = lowest == p ? parts.count() : partOfPoint[lowest];
    if (lowest == p)
    {
      parts.volumes.push_back(0.0);
    }
  }
  for (int f = 0; f < sites.faceCount(); ++f)
  {
    const auto& points = sites.points();
    const glm::ivec3& face = sites.faces()[f];
    parts.ofSite.push_back(partOfPoint[face.x]);
    parts.volumes[partOfPoint[face.x]] +=
      directions[f] * glm::dot(points[face.x], glm::cross(points[face.y], points[face.z]));
  }
  for (const glm::ivec2& edge : sites.edges())
  {
    parts.ofSite.push_back(partOfPoint[edge.x]);
  }
  parts.ofSite.insert(parts.ofSite.end(), partOfPoint.begin(), partOfPoint.end());
  return parts;
}

/// Which parts are next to each other in the solid, and which only seem to be.
struct PartPairs
{
  std::set<Pair> joined;
  std::set<Pair> apart;
};

class PairScan
{
public:
  PairScan(const SiteSet& sites, const std::vector<std::int8_t>& directions,
    const SurfaceParts& parts, const GridFrame& frame, const glm::ivec3& size,
    const std::int32_t* closestSites, const DepthField& depth)
    : sites_(sites)
    , directions_(directions)
    , parts_(parts)
    , frame_(frame)
    , size_(size)
    , closestSites_(closestSites)
    , depth_(depth)
  {
  }

  PartPairs run() const
  {
    tbb::enumerable_thread_specific<PartPairs> found;
    tbb::parallel_for(1, std::max(1, size_.z - 1),
      [&](int z)
      {
        PartPairs& pairs = found.local();
        for (int y = 1; y < size_.y - 1; ++y)
        {
          for (int x = 1; x < size_.x - 1; ++x)
          {
            this->visit({ x, y, z }, pairs);
          }
        }
      });
    PartPairs all;
    for (const PartPairs& each : found)
    {
      all.joined.insert(each.joined.begin(), each.joined.end());
      all.apart.insert(each.apart.begin(), each.apart.end());
    }
    return all;
  }

private:
  std::size_t index(const glm::ivec3& p) const
  {
    return (static_cast<std::size_t>(p.z) * size_.y + p.y) * size_.x + p.x;
  }
  bool isBody(int part) const { return parts_.volumes[part] > 0.0; }

  /// Whether a grid point lies outside of the part whose face is closest to it. Where parts touch
  /// or overlap it is in another one, and tells nothing about which parts are next to each other.
  bool isBehind(const glm::ivec3& p) const
  {
    const std::int32_t site = closestSites_[this->index(p)];
    if (sites_.kind(site) != SiteKind::Face)
    {
      return false;
    }
    const glm::dvec3& corner = sites_.points()[sites_.faces()[site][0]];
    return directions_[site] *
      glm::dot(sites_.faceNormal(site), frame_.sample(glm::dvec3(p)) - corner) >
      0.0;
  }

  /// Looks at the half of the 26 neighbours that come later.
  void visit(const glm::ivec3& p, PartPairs& pairs) const
  {
    const std::size_t here = this->index(p);
    if (!depth_.wanted(here) || this->isBehind(p))
    {
      return;
    }
    const int part = parts_.ofSite[closestSites_[here]];
    for (int step = 14; step < 27; ++step)
    {
      const glm::ivec3 offset(step % 3 - 1, step / 3 % 3 - 1, step / 9 - 1);
      const std::size_t there = this->index(p + offset);
      const int other = parts_.ofSite[closestSites_[there]];
      if (other == part || !depth_.wanted(there) || this->isBehind(p + offset))
      {
        continue;
      }
      const double length = glm::length(glm::dvec3(offset) * frame_.step);
      const auto covered = static_cast<double>(depth_.at(here) + depth_.at(there));
      const bool room =
        this->isBody(part) && this->isBody(other) && covered <= length * (1.0 + kOverlap);
      (room ? pairs.apart : pairs.joined).insert(std::minmax(part, other));
    }
  }

  const SiteSet& sites_;
  const std::vector<std::int8_t>& directions_;
  const SurfaceParts& parts_;
  const GridFrame& frame_;
  glm::ivec3 size_;
  const std::int32_t* closestSites_;
  const DepthField& depth_;
};

/// Gives each group the lowest colour that no group which it seems to touch has.
std::vector<int> coloured(DisjointSets& groups, const std::set<Pair>& apart)
{
  std::map<std::int64_t, std::set<std::int64_t>> conflicts;
  for (const auto& [a, b] : apart)
  {
    conflicts[groups.find(a)].insert(groups.find(b));
    conflicts[groups.find(b)].insert(groups.find(a));
  }
  std::vector<int> colours(static_cast<std::size_t>(groups.size()), 0);
  for (std::int64_t part = 0; part < groups.size(); ++part)
  {
    const std::int64_t group = groups.find(part);
    if (group != part)
    {
      colours[part] = colours[group];
      continue;
    }
    std::set<int> taken;
    for (const std::int64_t other : conflicts[group])
    {
      // Later groups have no colour yet.
      if (other < group)
      {
        taken.insert(colours[other]);
      }
    }
    while (taken.count(colours[part]) > 0)
    {
      ++colours[part];
    }
  }
  return colours;
}

} // namespace

SolidBodies::SolidBodies(const SiteSet& sites, const std::vector<std::int8_t>& directions,
  const GridFrame& frame, const glm::ivec3& size, const std::int32_t* closestSites,
  const DepthField& depth)
{
  const SurfaceParts parts = partsOf(sites, directions);
  if (parts.count() < 2)
  {
    return;
  }
  const PartPairs pairs =
    PairScan(sites, directions, parts, frame, size, closestSites, depth).run();
  DisjointSets groups(static_cast<std::size_t>(parts.count()));
  for (const auto& [a, b] : pairs.joined)
  {
    groups.join(a, b);
  }
  const std::vector<int> colours = coloured(groups, pairs.apart);
  for (const int part : parts.ofSite)
  {
    siteColours_.push_back(colours[part]);
    colours_ = std::max(colours_, colours[part] + 1);
  }
}

} // namespace medial
