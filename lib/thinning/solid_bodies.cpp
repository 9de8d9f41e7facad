#include "thinning/solid_bodies.h"

#include "base/disjoint_sets.h"
#include "base/simd.h"
#include "thinning/voxel_surface.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
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

using Pair = PartPairs::Pair;

SurfaceParts partsOf(const SiteSet& sites, const std::vector<std::int8_t>& directions)
{
  DisjointSets joined(sites.points().size());
  for (const glm::ivec2& edge : sites.edges())
  {
    joined.join(edge.x, edge.y);
  }
  SurfaceParts parts;
  std::vector<double> volumes;
  std::vector<int> partOfPoint(sites.points().size());
  for (std::size_t p = 0; p < partOfPoint.size(); ++p)
  {
    const auto lowest = static_cast<std::size_t>(joined.find(static_cast<std::int64_t>(p)));
    partOfPoint[p] = lowest == p ? static_cast<int>(volumes.size()) : partOfPoint[lowest];
    if (lowest == p)
    {
      volumes.push_back(0.0);
    }
  }
  for (int f = 0; f < sites.faceCount(); ++f)
  {
    const auto& points = sites.points();
    const glm::ivec3& face = sites.faces()[f];
    parts.ofSite.push_back(partOfPoint[face.x]);
    volumes[partOfPoint[face.x]] +=
      enclosedBy(points[face.x], points[face.y], points[face.z], directions[f]);
  }
  for (const glm::ivec2& edge : sites.edges())
  {
    parts.ofSite.push_back(partOfPoint[edge.x]);
  }
  parts.ofSite.insert(parts.ofSite.end(), partOfPoint.begin(), partOfPoint.end());
  std::transform(volumes.begin(), volumes.end(), std::back_inserter(parts.areBodies),
    [](double volume) { return volume > 0.0 ? 1 : 0; });
  return parts;
}

/// Marks the places of a row where a neighbour belongs to another part; negative numbers stand for
/// none.
MEDIAL_VECTORISED void markOthers(const int* parts, const int* neighbours, int count,
  std::uint8_t* marks)
{
  for (int x = 0; x < count; ++x)
  {
    marks[x] |= parts[x] != neighbours[x] && parts[x] >= 0 && neighbours[x] >= 0 ? 1 : 0;
  }
}

class PairScan
{
public:
  PairScan(const FieldOfParts& field, const SurfaceParts& parts)
    : field_(field)
    , parts_(parts)
    , first_(field.part.min[0], field.part.min[1], field.part.min[2])
    , last_(field.part.max[0], field.part.max[1], field.part.max[2])
  {
  }

  PartPairs run() const
  {
    tbb::enumerable_thread_specific<PartPairs> found;
    // Points on the border of the grid are in no solid.
    const glm::ivec3 low = glm::max(first_, 1);
    const glm::ivec3 high = glm::min(last_, field_.grid - 2);
    constexpr int kTogether = 8;
    tbb::parallel_for(tbb::blocked_range<int>(low.z, std::max(low.z, high.z + 1), kTogether),
      [&](const tbb::blocked_range<int>& range)
      {
        PartPairs& pairs = found.local();
        std::array<std::vector<int>, 2> layers;
        std::vector<std::uint8_t> marks(static_cast<std::size_t>(std::max(0, high.x - low.x + 1)));
        this->load(range.begin(), layers[1]);
        for (int z = range.begin(); z < range.end(); ++z)
        {
          std::swap(layers[0], layers[1]);
          this->load(z + 1, layers[1]);
          for (int y = low.y; y <= high.y; ++y)
          {
            std::fill(marks.begin(), marks.end(), std::uint8_t{ 0 });
            for (int step = kFirstLater; step < kAround; ++step)
            {
              const glm::ivec3 offset = offsetOf(step);
              markOthers(this->row(layers[0], low.x, y),
                this->row(layers[static_cast<std::size_t>(offset.z)], low.x + offset.x,
                  y + offset.y),
                static_cast<int>(marks.size()), marks.data());
            }
            for (int x = low.x; x <= high.x; ++x)
            {
              if (marks[x - low.x] != 0)
              {
                this->visit({ x, y, z }, pairs);
              }
            }
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
  /// Of the voxels around one, those that come later begin here.
  static constexpr int kFirstLater = kCentre + 1;

  /// Loads the parts that the points of a layer are closest to; -1 for those beyond the side or the
  /// part of the grid. Rows have a point more at both ends, and a row more on both sides.
  void load(int z, std::vector<int>& layer) const
  {
    const Extent& part = field_.part;
    layer.assign(static_cast<std::size_t>(part.size(0) + 2) * (part.size(1) + 2), -1);
    if (z > last_.z)
    {
      return;
    }
    for (int y = first_.y; y <= last_.y; ++y)
    {
      int* const row = layer.data() + this->place(first_.x, y);
      const std::size_t begin = this->index({ first_.x, y, z });
      for (int x = 0; x < part.size(0); ++x)
      {
        row[x] =
          field_.depth.wanted(begin + x) ? parts_.ofSite[field_.closestSites[begin + x]] : -1;
      }
    }
  }

  const int* row(const std::vector<int>& layer, int x, int y) const
  {
    return layer.data() + this->place(x, y);
  }
  std::size_t place(int x, int y) const
  {
    return static_cast<std::size_t>(y - first_.y + 1) * (field_.part.size(0) + 2) +
      (x - first_.x + 1);
  }

  std::size_t index(const glm::ivec3& point) const
  {
    const glm::ivec3 p = point - first_;
    return (static_cast<std::size_t>(p.z) * field_.part.size(1) + p.y) * field_.part.size(0) + p.x;
  }
  bool isBody(int part) const { return parts_.areBodies[part] != 0; }

  /// Whether a grid point lies outside of the part whose face is closest to it. Where parts touch
  /// or overlap it is in another one, and tells nothing about which parts are next to each other.
  bool isBehind(const glm::ivec3& p) const
  {
    const std::int32_t site = field_.closestSites[this->index(p)];
    if (field_.sites.kind(site) != SiteKind::Face)
    {
      return false;
    }
    const glm::dvec3& corner = field_.sites.points()[field_.sites.faces()[site][0]];
    return field_.directions[site] *
      glm::dot(field_.sites.faceNormal(site), field_.frame.sample(glm::dvec3(p)) - corner) >
      0.0;
  }

  /// Looks at the half of the 26 neighbours that come later.
  void visit(const glm::ivec3& p, PartPairs& pairs) const
  {
    const std::size_t here = this->index(p);
    if (!field_.depth.wanted(here) || this->isBehind(p))
    {
      return;
    }
    const int part = parts_.ofSite[field_.closestSites[here]];
    for (int step = kFirstLater; step < kAround; ++step)
    {
      const glm::ivec3 offset = offsetOf(step);
      if (glm::clamp(p + offset, first_, last_) != p + offset)
      {
        continue;
      }
      const std::size_t there = this->index(p + offset);
      const int other = parts_.ofSite[field_.closestSites[there]];
      if (other == part || !field_.depth.wanted(there) || this->isBehind(p + offset))
      {
        continue;
      }
      const double length = glm::length(glm::dvec3(offset) * field_.frame.step);
      const auto covered = static_cast<double>(field_.depth.at(here) + field_.depth.at(there));
      const bool room =
        this->isBody(part) && this->isBody(other) && covered <= length * (1.0 + kOverlap);
      (room ? pairs.apart : pairs.joined).insert(std::minmax(part, other));
    }
  }

  const FieldOfParts& field_;
  const SurfaceParts& parts_;
  glm::ivec3 first_;
  glm::ivec3 last_;
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

PartPairs pairsOfParts(const FieldOfParts& field, const SurfaceParts& parts)
{
  return PairScan(field, parts).run();
}

std::vector<int> coloursOfParts(int parts, const PartPairs& pairs)
{
  DisjointSets groups(static_cast<std::size_t>(parts));
  for (const auto& [a, b] : pairs.joined)
  {
    groups.join(a, b);
  }
  return coloured(groups, pairs.apart);
}

SolidBodies::SolidBodies(const SiteSet& sites, const std::vector<std::int8_t>& directions,
  const GridFrame& frame, const glm::ivec3& size, const std::int32_t* closestSites,
  const DepthField& depth)
{
  const SurfaceParts parts = partsOf(sites, directions);
  if (parts.count() < 2)
  {
    return;
  }
  const Extent whole{ { 0, 0, 0 }, { size.x - 1, size.y - 1, size.z - 1 } };
  const std::vector<int> colours = coloursOfParts(parts.count(),
    pairsOfParts({ sites, directions, frame, whole, size, closestSites, depth }, parts));
  for (const int part : parts.ofSite)
  {
    siteColours_.push_back(colours[part]);
    colours_ = std::max(colours_, colours[part] + 1);
  }
}

} // namespace medial
