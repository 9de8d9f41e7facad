#include "medial/culling/candidate_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{

CandidateFilter::CandidateFilter(const SiteSet& sites)
  : sites_(sites)
{
  facePlanes_.reserve(sites.faceCount());
  for (int face = 0; face < sites.faceCount(); ++face)
  {
    const glm::dvec3& normal = sites.faceNormal(face);
    const glm::dvec3& corner = sites.points()[sites.faces()[face][0]];
    facePlanes_.emplace_back(
      glm::vec3(normal), static_cast<float>(glm::dot(normal, corner)));
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

CandidateFilter::Interval CandidateFilter::bounds(int site, const glm::vec3& x) const
{
  constexpr float kUnknown = std::numeric_limits<float>::max();
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
    {
      // Inside its prism a face is at plane distance; elsewhere its edges bound the distance from
      // above, so only a lower bound is needed.
      const HalfSpace& plane = facePlanes_[site];
      const float height = std::abs(glm::dot(glm::vec3(plane), x) - plane.w);
      float excess = 0.0f;
      const HalfSpace* side = sites_.halfSpacesBegin(site);
      for (int i = 0; i < 3; ++i)
      {
        excess = std::max(excess, glm::dot(glm::vec3(side[i]), x) - side[i].w);
      }
      if (excess <= 0.0f)
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
  const HalfSpace* end = sites_.halfSpacesEnd(site);
  for (const HalfSpace* h = sites_.halfSpacesBegin(site); h != end; ++h)
  {
    const glm::vec3 normal(*h);
    const float nearest = glm::dot(normal, box.centre) - h->w - glm::dot(glm::abs(normal), box.half);
    if (nearest > slack_)
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
    const Interval interval = this->bounds(parent[i], box.centre);
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
