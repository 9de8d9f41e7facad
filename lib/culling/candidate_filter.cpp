#include "medial/culling/candidate_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{

CandidateFilter::CandidateFilter(const SiteSet& sites)
  : sites_(sites)
  , packs_(sites)
{
  facePlanes_.reserve(sites.faceCount());
  for (int face = 0; face < sites.faceCount(); ++face)
  {
    const glm::dvec3& normal = sites.faceNormal(face);
    const glm::dvec3& corner = sites.points()[sites.faces()[face][0]];
    PlanePack pack{};
    for (int i = 0; i < 3 && sites.active(face); ++i)
    {
      pack.set(i, sites.halfSpacesBegin(face)[i]);
    }
    pack.set(3, { glm::vec3(normal), static_cast<float>(glm::dot(normal, corner)) });
    facePlanes_.push_back(pack);
  }
  edgeLines_.reserve(sites.edgeCount());
  for (const glm::ivec2& ends : sites.edges())
  {
    const glm::dvec3 start = sites.points()[ends[0]];
    const glm::dvec3 along = sites.points()[ends[1]] - start;
    const double length = glm::length(along);
    edgeLines_.push_back(
      { glm::vec3(start), static_cast<float>(length), glm::vec3(along / length) });
  }
  float reach = 0.0f;
  for (int site = sites.firstVertex(); site < sites.size(); ++site)
  {
    reach = std::max(reach, glm::length(glm::vec3(sites.sphere(site))));
  }
  constexpr float kLeastSlack = 1e-3f;
  slack_ = kLeastSlack + 16.0f * std::numeric_limits<float>::epsilon() * reach;
}

std::vector<int> CandidateFilter::allSites() const
{
  std::vector<int> all;
  all.reserve(sites_.size());
  for (int site = 0; site < sites_.size(); ++site)
  {
    if (sites_.active(site))
    {
      all.push_back(site);
    }
  }
  return all;
}

DistanceBounds CandidateFilter::bounds(int site, const glm::vec3& x) const
{
  constexpr float kUnknown = std::numeric_limits<float>::max();
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
    {
      // Inside its prism a face is at plane distance; elsewhere its edges bound the distance from
      // above, so only a lower bound is needed.
      const Float4 values = facePlanes_[site].evaluate(x);
      const float excess = std::max({ 0.0f, values[0], values[1], values[2] });
      const float height = std::abs(values[3]);
      // Beyond an acute corner of a needle both long sides round to 0; the ends tell.
      const HalfSpace* ends = sites_.halfSpacesBegin(site) + 3;
      const auto beyond = [&](const HalfSpace& h) { return glm::dot(glm::vec3(h), x) > h.w; };
      if (excess <= 0.0f && !beyond(ends[0]) && !beyond(ends[1]))
      {
        return { height, height };
      }
      return { std::sqrt(height * height + excess * excess), kUnknown };
    }
    case SiteKind::Edge:
    {
      const EdgeLine& line = edgeLines_[site - sites_.firstEdge()];
      const glm::vec3 v = x - line.start;
      const float t = glm::clamp(glm::dot(v, line.direction), 0.0f, line.length);
      const float distance = glm::length(v - t * line.direction);
      return { distance, distance };
    }
    case SiteKind::Vertex:
      break;
  }
  const float distance = glm::distance(x, glm::vec3(sites_.sphere(site)));
  return { distance, distance };
}

bool CandidateFilter::outside(int site, const FrameBox& box) const
{
  const PlanePack* end = packs_.end(site);
  for (const PlanePack* pack = packs_.begin(site); pack != end; ++pack)
  {
    const auto beyond = pack->evaluateBox(box.centre, box.half) > slack_;
    if ((beyond[0] | beyond[1] | beyond[2] | beyond[3]) != 0)
    {
      return true;
    }
  }
  return false;
}

void CandidateFilter::filter(const std::vector<int>& parent, const FrameBox& box,
  std::vector<int>& out, Scratch& scratch) const
{
  const float radius = glm::length(box.half);
  const float reach = 2.0f * radius + slack_;
  // Spheres first: cheap, and a good start for the upper bound.
  scratch.lower.resize(parent.size());
  float upper = std::numeric_limits<float>::max();
  for (std::size_t i = 0; i < parent.size(); ++i)
  {
    const glm::vec4& sphere = sites_.sphere(parent[i]);
    const float distance = glm::distance(box.centre, glm::vec3(sphere));
    scratch.lower[i] = distance - sphere.w;
    upper = std::min(upper, distance + sphere.w);
  }
  scratch.kept.clear();
  for (std::size_t i = 0; i < parent.size(); ++i)
  {
    if (scratch.lower[i] > upper + reach)
    {
      continue;
    }
    const DistanceBounds interval = this->bounds(parent[i], box.centre);
    upper = std::min(upper, interval.upper);
    if (interval.lower <= upper + reach)
    {
      scratch.kept.emplace_back(interval.lower, parent[i]);
    }
  }
  for (const auto& [lower, site] : scratch.kept)
  {
    if (lower <= upper + reach && !this->outside(site, box))
    {
      out.push_back(site);
    }
  }
}

} // namespace medial
