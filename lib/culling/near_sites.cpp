#include "base/simd.h"
#include "culling/candidate_filter.h"

#include <limits>

namespace medial
{
namespace
{

static_assert(PointLanes::kMax == kLanes);

constexpr float kUnknown = std::numeric_limits<float>::max();

struct Vector8
{
  Float8 x, y, z;

  MEDIAL_INLINE Float8 squaredLength() const { return x * x + y * y + z * z; }
};

MEDIAL_INLINE Vector8 fromPoint(const Vector8& x, const glm::vec3& point)
{
  return { x.x - point.x, x.y - point.y, x.z - point.z };
}

MEDIAL_INLINE Float8 along(const Vector8& x, const glm::vec3& direction)
{
  return x.x * direction.x + x.y * direction.y + x.z * direction.z;
}

MEDIAL_INLINE Float8 evaluate(const HalfSpace& plane, const Vector8& x)
{
  return along(x, glm::vec3(plane)) - plane.w;
}

} // namespace

MEDIAL_VECTORISED void CandidateFilter::near(const int* begin, const int* end,
  const PointLanes& points, std::vector<NearSite>& found) const
{
  found.clear();
  const Vector8 x{ loaded(points.x.data()), loaded(points.y.data()), loaded(points.z.data()) };
  Float8 reach = loaded(points.reach.data());
  const unsigned used = (1u << points.count) - 1u;
  if ((bits(reach >= kUnknown) & used) != 0)
  {
    // The centres of these balls are points of the surface.
    Float8 nearest = splat(kUnknown);
    for (const int* site = begin; site != end; ++site)
    {
      nearest = min(nearest, fromPoint(x, glm::vec3(sites_.boundingBall(*site))).squaredLength());
    }
    for (int i = 0; i < points.count; ++i)
    {
      reach[i] = std::min(reach[i], std::sqrt(nearest[i]) + slack_);
    }
  }
  const Float8 squaredReach = reach * reach;
  for (const int* candidate = begin; candidate != end; ++candidate)
  {
    const int site = *candidate;
    const glm::vec4& sphere = sites_.boundingBall(site);
    const Float8 toSphere = reach + sphere.w;
    Float8 squared = fromPoint(x, glm::vec3(sphere)).squaredLength();
    unsigned near = bits(squared <= toSphere * toSphere) & used;
    if (near == 0)
    {
      continue;
    }
    switch (sites_.kind(site))
    {
      case SiteKind::Face:
      {
        // Only a lower bound where a point does not project into the face; there its edges count,
        // which are sites as well.
        const FacePlanes& face = facePlanes_[site];
        const Float8 height = evaluate(face.plane, x);
        const Float8 side = max(max(evaluate(face.sides[0], x), evaluate(face.sides[1], x)),
          evaluate(face.sides[2], x));
        const Float8 excess = max(side, Float8{});
        squared = height * height + excess * excess;
        break;
      }
      case SiteKind::Edge:
      {
        const EdgeLine& line = edgeLines_[site - sites_.firstEdge()];
        Vector8 v = fromPoint(x, line.start);
        const Float8 t = min(max(along(v, line.direction), Float8{}), splat(line.length));
        v = { v.x - t * line.direction.x, v.y - t * line.direction.y, v.z - t * line.direction.z };
        squared = v.squaredLength();
        break;
      }
      case SiteKind::Vertex:
        break;
    }
    near &= bits(squared <= squaredReach);
    if (near != 0)
    {
      found.push_back({ site, near });
    }
  }
}

} // namespace medial
