#include "proximity/element_distance.h"

#include <algorithm>

namespace medial
{
namespace
{

/// The plane of a triangle, and the planes through its edges.
struct TrianglePlanes
{
  explicit TrianglePlanes(const Element& triangle)
    : corners(triangle.corners)
  {
    const glm::dvec3 along[] = { corners[1] - corners[0], corners[2] - corners[1],
      corners[0] - corners[2] };
    normal = glm::cross(along[0], along[1]);
    squared = glm::dot(normal, normal);
    double longest = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      inward[i] = glm::cross(normal, along[i]);
      longest = std::max(longest, glm::dot(along[i], along[i]));
    }
    hasArea = squared > kMinHeight * kMinHeight * longest * longest;
  }

  bool isAbove(const glm::dvec3& x) const
  {
    return glm::dot(inward[0], x - corners[0]) > 0.0 && glm::dot(inward[1], x - corners[1]) > 0.0 &&
      glm::dot(inward[2], x - corners[2]) > 0.0;
  }
  double height(const glm::dvec3& x) const { return glm::dot(normal, x - corners[0]); }
  glm::dvec3 project(const glm::dvec3& x) const { return x - this->height(x) / squared * normal; }

  const std::array<glm::dvec3, 3>& corners;
  glm::dvec3 normal;
  glm::dvec3 inward[3];
  double squared;
  bool hasArea;
};

void tryPoints(const glm::dvec3& a, const glm::dvec3& b, ClosePoints& found)
{
  const double squared = glm::dot(a - b, a - b);
  if (squared < found.squared)
  {
    found = { squared, a, b };
  }
}

/// The closest points of segments p + s u and q + t v, s and t in [0, 1].
void trySegments(const glm::dvec3& p, const glm::dvec3& u, const glm::dvec3& q, const glm::dvec3& v,
  ClosePoints& found)
{
  const glm::dvec3 r = p - q;
  const double uu = glm::dot(u, u);
  const double vv = glm::dot(v, v);
  const double uv = glm::dot(u, v);
  const double ur = glm::dot(u, r);
  const double vr = glm::dot(v, r);
  const auto clamped = [](double x) { return x > 0.0 ? std::min(x, 1.0) : 0.0; };
  const auto ratio = [&](double x, double y) { return y > 0.0 ? clamped(x / y) : 0.0; };
  const double determinant = uu * vv - uv * uv;
  // Parallel ones: any place will do, since both ends are tried below by clamping.
  constexpr double kParallel = 1e-14;
  double s = determinant > kParallel * uu * vv ? clamped((uv * vr - vv * ur) / determinant) : 0.0;
  const double t = ratio(uv * s + vr, vv);
  s = ratio(uv * t - ur, uu);
  tryPoints(p + s * u, q + t * v, found);
}

void tryCorners(const TrianglePlanes& triangle, const Element& other, bool swapped,
  ClosePoints& found)
{
  for (const glm::dvec3& x : other.corners)
  {
    const double height = triangle.height(x);
    if (height * height < found.squared * triangle.squared && triangle.isAbove(x))
    {
      const glm::dvec3 foot = triangle.project(x);
      swapped ? tryPoints(x, foot, found) : tryPoints(foot, x, found);
    }
  }
}

} // namespace

ClosePoints closestPoints(const Element& a, const Element& b)
{
  ClosePoints found;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& p = a.corners[i];
    const glm::dvec3 u = a.corners[(i + 1) % 3] - p;
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec3& q = b.corners[k];
      trySegments(p, u, q, b.corners[(k + 1) % 3] - q, found);
    }
  }
  const TrianglePlanes planesA(a);
  if (planesA.hasArea)
  {
    tryCorners(planesA, b, false, found);
  }
  const TrianglePlanes planesB(b);
  if (planesB.hasArea)
  {
    tryCorners(planesB, a, true, found);
  }
  return found;
}

glm::dvec3 closestOnEdges(const Element& element, const glm::dvec3& x)
{
  ClosePoints found;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& p = element.corners[i];
    const glm::dvec3 u = element.corners[(i + 1) % 3] - p;
    const double squared = glm::dot(u, u);
    const double s = squared > 0.0 ? std::clamp(glm::dot(x - p, u) / squared, 0.0, 1.0) : 0.0;
    tryPoints(p + s * u, x, found);
  }
  return found.a;
}

} // namespace medial
