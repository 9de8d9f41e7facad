#include "axis/seams/seam_cells.h"

#include "axis/bisector.h"
#include "axis/side_directions.h"
#include "axis/tile_order.h"
#include "base/extents.h"
#include "base/sorted_set.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace medial
{
namespace
{

const double kSameSideCosine = std::cos(glm::radians(kOneSideSpan));
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

} // namespace

SeamCells::SeamCells(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
  const glm::ivec2& slices)
  : geometry_(geometry)
  , crossings_(crossings)
  , mesh_(dualMesh(crossings, geometry.part))
  , slots_(crossings.size(), kNone)
{
  this->findVertices(slices);
  this->findPoints(this->numberPoints());
}

/// Whether the crossings of a cell see more than two sides of the surface.
bool SeamCells::hasSeam(std::size_t vertex) const
{
  const glm::dvec3 centre = geometry_.frame.sample(glm::dvec3(mesh_.cells[vertex]) + 0.5);
  glm::dvec3 sides[2];
  std::size_t count = 0;
  int last[2] = { -1, -1 };
  for (const std::uint32_t* c = this->begin(vertex); c != this->end(vertex); ++c)
  {
    for (const int site : { crossings_[*c].siteA, crossings_[*c].siteB })
    {
      if (site == last[0] || site == last[1])
      {
        continue;
      }
      last[1] = last[0];
      last[0] = site;
      const glm::dvec3 way = closestPoint(geometry_.sites, site, centre).point - centre;
      const auto sideAt = [&sides](std::size_t side) -> const glm::dvec3& { return sides[side]; };
      if (closestDirection(count, sideAt, way, kSameSideCosine) >= 0)
      {
        continue;
      }
      if (count == 2)
      {
        return true;
      }
      sides[count++] = glm::normalize(way);
    }
  }
  return false;
}

/// Finds the cells with seams, and those that share a crossing with one.
void SeamCells::findVertices(const glm::ivec2& slices)
{
  const std::size_t count = mesh_.cells.size();
  std::vector<std::uint8_t> seams(count, 0);
  inBlocks(geometry_, count,
    [&](std::size_t begin, std::size_t end)
    {
      for (std::size_t v = begin; v != end; ++v)
      {
        seams[v] = this->hasSeam(v) ? 1 : 0;
      }
    });
  std::vector<std::uint8_t> wanted(count, 0);
  for (const auto& corners : mesh_.corners)
  {
    if (std::any_of(corners.begin(), corners.end(),
          [&](std::uint32_t corner) { return seams[corner] != 0; }))
    {
      for (const std::uint32_t corner : corners)
      {
        wanted[corner] = 1;
      }
    }
  }
  const std::vector<std::uint32_t> order =
    tileOrder(geometry_.part, count, [&](std::size_t v) { return mesh_.cells[v]; });
  std::copy_if(order.begin(), order.end(), std::back_inserter(vertices_),
    [&](std::uint32_t v)
    {
      const glm::ivec3& cell = mesh_.cells[v];
      return wanted[v] != 0 && hasCell(geometry_.extent, cell) && cell.z >= slices.x &&
        cell.z < slices.y;
    });
}

/// Returns the crossings of the cells, in the order of their points.
std::vector<std::uint32_t> SeamCells::numberPoints()
{
  std::vector<std::uint32_t> crossings;
  for (const std::uint32_t v : vertices_)
  {
    for (const std::uint32_t* c = this->begin(v); c != this->end(v); ++c)
    {
      if (slots_[*c] == kNone)
      {
        slots_[*c] = static_cast<std::uint32_t>(crossings.size());
        crossings.push_back(*c);
      }
    }
  }
  return crossings;
}

void SeamCells::findPoints(const std::vector<std::uint32_t>& crossings)
{
  points_.resize(crossings.size());
  const auto others = resultsOfBlocks(geometry_, crossings.size(),
    [&](std::size_t begin, std::size_t end)
    { return this->findPoints(crossings.data() + begin, crossings.data() + end); });
  for (const std::vector<OtherPoint>& some : others)
  {
    others_.insert(others_.end(), some.begin(), some.end());
  }
  std::stable_sort(others_.begin(), others_.end(),
    [](const OtherPoint& p, const OtherPoint& q) { return p.first < q.first; });
}

/// Finds the points of some crossings. Returns those where another sheet crosses the same edge,
/// before or behind the first one.
std::vector<SeamCells::OtherPoint> SeamCells::findPoints(const std::uint32_t* begin,
  const std::uint32_t* end)
{
  std::vector<SiteSegment> edges;
  for (const std::uint32_t* c = begin; c != end; ++c)
  {
    edges.push_back(segmentOf(geometry_.frame, crossings_[*c]));
  }
  const std::vector<BisectorPoint> points = bisectorPoints(geometry_, edges);
  std::vector<SiteSegment> rests;
  std::vector<std::uint32_t> owners;
  const auto addRest = [&](std::uint32_t crossing, const SiteSegment& rest)
  {
    rests.push_back(rest);
    owners.push_back(crossing);
  };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const SiteSegment& edge = edges[i];
    const BisectorPoint& point = points[i];
    points_[slots_[begin[i]]] = point;
    if (this->areTwoSides(edge.fromSite, point.a, point.position))
    {
      addRest(begin[i], { edge.from, edge.fromSite, point.position, point.a.site });
    }
    if (this->areTwoSides(edge.toSite, point.b, point.position))
    {
      addRest(begin[i], { point.position, point.b.site, edge.to, edge.toSite });
    }
  }
  const std::vector<BisectorPoint> found = bisectorPoints(geometry_, rests);
  std::vector<OtherPoint> others;
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    others.emplace_back(owners[i], found[i]);
  }
  return others;
}

bool SeamCells::areTwoSides(int site, const SitePoint& near, const glm::dvec3& x) const
{
  if (site == near.site)
  {
    return false;
  }
  const glm::dvec3 way = closestPoint(geometry_.sites, site, x).point - x;
  const glm::dvec3 other = near.point - x;
  return glm::dot(way, other) < kSameSideCosine * glm::length(way) * glm::length(other);
}

std::vector<SeamCells::OtherPoint>::const_iterator SeamCells::firstOther(
  std::uint32_t crossing) const
{
  return std::lower_bound(others_.begin(), others_.end(), crossing,
    [](const OtherPoint& point, std::uint32_t wanted) { return point.first < wanted; });
}

std::vector<SeenSite> SeamCells::sitesAround(std::size_t vertex) const
{
  std::vector<std::uint32_t> crossings;
  for (const std::uint32_t* c = this->begin(vertex); c != this->end(vertex); ++c)
  {
    for (const std::uint32_t corner : mesh_.corners[*c])
    {
      crossings.insert(crossings.end(), this->begin(corner), this->end(corner));
    }
  }
  makeSet(crossings);
  std::vector<SeenSite> sites;
  for (const std::uint32_t c : crossings)
  {
    const SiteSegment edge = segmentOf(geometry_.frame, crossings_[c]);
    sites.push_back({ edge.fromSite, edge.from });
    sites.push_back({ edge.toSite, edge.to });
  }
  this->forPoints(vertex,
    [&](const BisectorPoint& point)
    {
      sites.push_back({ point.a.site, point.position });
      sites.push_back({ point.b.site, point.position });
    });
  std::stable_sort(sites.begin(), sites.end(),
    [](const SeenSite& p, const SeenSite& q) { return p.site < q.site; });
  const auto isSame = [](const SeenSite& p, const SeenSite& q) { return p.site == q.site; };
  sites.erase(std::unique(sites.begin(), sites.end(), isSame), sites.end());
  return sites;
}

} // namespace medial
