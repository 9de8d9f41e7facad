#include "field/engines/processor/crossing_filter.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <limits>

namespace medial
{
namespace
{

using Vector8 = std::array<Float8, 3>;

MEDIAL_INLINE Float8 dot(const Vector8& a, const Vector8& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Reads eight tables of eight values each, and returns the lanes of every value.
MEDIAL_INLINE void transposed(const float* const* rows, Float8* columns)
{
  alignas(32) float values[kLanes][kLanes];
  for (int lane = 0; lane < kLanes; ++lane)
  {
    for (int i = 0; i < kLanes; ++i)
    {
      values[i][lane] = rows[lane][i];
    }
  }
  for (int i = 0; i < kLanes; ++i)
  {
    columns[i] = loaded(values[i]);
  }
}

/// Returns the displacements from positions to sites, each described by eight values.
MEDIAL_INLINE Vector8 displacementsFrom(const Vector8& x, const float* const* rows)
{
  Float8 columns[kLanes];
  transposed(rows, columns);
  const Vector8 v = { columns[0] - x[0], columns[1] - x[1], columns[2] - x[2] };
  const Vector8 direction = { columns[4], columns[5], columns[6] };
  const Float8 along = columns[7] * dot(v, direction);
  return { columns[3] * v[0] + along * direction[0], columns[3] * v[1] + along * direction[1],
    columns[3] * v[2] + along * direction[2] };
}

} // namespace

CrossingFilter::CrossingFilter(const CrossingSelection& selection, const SiteSet& sites,
  const GridFrame& frame, float slack)
  : cosineLimit_(static_cast<float>(std::cos(glm::radians(selection.angle))))
  , slack_(slack)
  , step_{ static_cast<float>(frame.step.x), static_cast<float>(frame.step.y),
    static_cast<float>(frame.step.z) }
  , displacements_(sites.size())
{
  tbb::parallel_for(0, sites.size(),
    [&](int site) { displacements_[site] = this->displacementOf(sites, site); });
}

CrossingFilter::Displacement CrossingFilter::displacementOf(const SiteSet& sites, int site) const
{
  glm::dvec3 start(0.0);
  glm::dvec3 direction(0.0);
  float whole = 1.0f;
  float part = 0.0f;
  switch (sites.kind(site))
  {
    case SiteKind::Face:
      start = sites.points()[sites.faces()[site][0]];
      direction = sites.faceNormal(site);
      whole = 0.0f;
      part = 1.0f;
      break;
    case SiteKind::Edge:
    {
      const glm::ivec2& ends = sites.edges()[site - sites.firstEdge()];
      start = sites.points()[ends[0]];
      const glm::dvec3 along = sites.points()[ends[1]] - start;
      direction = along / glm::length(along); // not a number without length: nothing is ruled out
      part = -1.0f;
      break;
    }
    case SiteKind::Vertex:
      start = sites.points()[site - sites.firstVertex()];
      break;
  }
  const glm::vec3 s(start);
  const glm::vec3 d(direction);
  return { { s.x, s.y, s.z }, whole, { d.x, d.y, d.z }, part };
}

MEDIAL_VECTORISED unsigned CrossingFilter::mayBeCrossed(const Edges& edges) const
{
  const float* rowsA[kLanes];
  const float* rowsB[kLanes];
  for (int lane = 0; lane < kLanes; ++lane)
  {
    rowsA[lane] = displacements_[edges.siteA[lane]].start;
    rowsB[lane] = displacements_[edges.siteB[lane]].start;
  }
  const Int8 axis = loadedInts(edges.axis.data());
  Vector8 from;
  Vector8 edge;
  Vector8 to;
  for (int i = 0; i < 3; ++i)
  {
    from[i] = loaded(edges.from[i].data());
    edge[i] = axis == i ? splat(step_[i]) : Float8{};
    to[i] = from[i] + edge[i];
  }
  const Vector8 near = displacementsFrom(from, rowsA);
  const Vector8 far = displacementsFrom(to, rowsB);
  const Vector8 gap = { edge[0] + far[0] - near[0], edge[1] + far[1] - near[1],
    edge[2] + far[2] - near[2] };
  const Float8 squaredNear = dot(near, near);
  const Float8 squaredFar = dot(far, far);
  const Float8 lengths = squareRoot(squaredNear * squaredFar);
  // Both displacements may be off by this much.
  const float off = 4.0f * slack_;
  constexpr float kRounding = 1e-5f;
  const Float8 doubt =
    2.0f * off * (squareRoot(2.0f * (squaredNear + squaredFar)) + off) + kRounding * lengths;
  const Int8 narrow = dot(near, far) - cosineLimit_ * lengths > doubt;
  const Float8 limit = max(squareRoot(dot(edge, edge)) * (1.0f - kRounding) - 2.0f * off, Float8{});
  const Int8 close = dot(gap, gap) < limit * limit;
  return ~bits(narrow | close) & 0xffu;
}

} // namespace medial
