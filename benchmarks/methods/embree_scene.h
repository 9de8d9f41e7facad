#pragma once

#include "medial/grid.h"
#include "medial/triangle_mesh.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace medial::benchmark::embree
{

struct Vector
{
  float x, y, z;
};

inline float dot(const Vector& a, const Vector& b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vector minus(const Vector& a, const Vector& b)
{
  return { a.x - b.x, a.y - b.y, a.z - b.z };
}

/// A triangle as a corner and two edges, with the products that every query needs.
struct Triangle
{
  Vector corner, u, v;
  float uu, uv, vv;
};

inline Triangle makeTriangle(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector u = minus(b, a);
  const Vector v = minus(c, a);
  return { a, u, v, dot(u, u), dot(u, v), dot(v, v) };
}

/// 0 instead of a quotient by 0, which edges without length give.
inline float share(float part, float whole)
{
  return whole > 0.0F ? part / whole : 0.0F;
}

inline float squaredDistanceAt(const Triangle& t, const Vector& fromCorner, float s, float r)
{
  const Vector d{ fromCorner.x - s * t.u.x - r * t.v.x, fromCorner.y - s * t.u.y - r * t.v.y,
    fromCorner.z - s * t.u.z - r * t.v.z };
  return dot(d, d);
}

/// Squared distance to the point corner + s u + r v of a triangle that is nearest to `query`: which
/// of the seven regions of the plane the projection falls into follows from signs of products.
inline float squaredDistance(const Triangle& t, const Vector& query)
{
  const Vector w = minus(query, t.corner);
  const float wu = dot(w, t.u);
  const float wv = dot(w, t.v);
  if (wu <= 0.0F && wv <= 0.0F)
  {
    return dot(w, w);
  }
  const float bu = wu - t.uu;
  const float bv = wv - t.uv;
  if (bu >= 0.0F && bv <= bu)
  {
    return squaredDistanceAt(t, w, 1.0F, 0.0F);
  }
  const float overU = wu * bv - bu * wv;
  if (overU <= 0.0F && wu >= 0.0F && bu <= 0.0F)
  {
    return squaredDistanceAt(t, w, share(wu, t.uu), 0.0F);
  }
  const float cu = wu - t.uv;
  const float cv = wv - t.vv;
  if (cv >= 0.0F && cu <= cv)
  {
    return squaredDistanceAt(t, w, 0.0F, 1.0F);
  }
  const float overV = cu * wv - wu * cv;
  if (overV <= 0.0F && wv >= 0.0F && cv <= 0.0F)
  {
    return squaredDistanceAt(t, w, 0.0F, share(wv, t.vv));
  }
  const float overThird = bu * cv - cu * bv;
  const float alongB = bv - bu;
  const float alongC = cu - cv;
  if (overThird <= 0.0F && alongB >= 0.0F && alongC >= 0.0F)
  {
    const float r = share(alongB, alongB + alongC);
    return squaredDistanceAt(t, w, 1.0F - r, r);
  }
  const float sum = overThird + overU + overV;
  return squaredDistanceAt(t, w, share(overV, sum), share(overU, sum));
}

struct Nearest
{
  const Triangle* triangles;
  Vector query;
  float squared;
  std::int32_t triangle;
};

inline bool visitTriangle(RTCPointQueryFunctionArguments* arguments)
{
  auto& nearest = *static_cast<Nearest*>(arguments->userPtr);
  const float squared = squaredDistance(nearest.triangles[arguments->primID], nearest.query);
  if (squared >= nearest.squared)
  {
    return false;
  }
  nearest.squared = squared;
  nearest.triangle = static_cast<std::int32_t>(arguments->primID);
  arguments->query->radius = std::sqrt(squared);
  return true;
}

/// Triangles in single precision relative to an origin, and Embree's tree over them.
class EmbreeScene
{
public:
  EmbreeScene(const TriangleMesh& mesh, const Point3& origin)
    : device_(rtcNewDevice(nullptr))
  {
    if (!device_)
    {
      throw std::runtime_error("Embree gives no device");
    }
    std::vector<Vector> points;
    points.reserve(mesh.points.size());
    for (const Point3& p : mesh.points)
    {
      points.push_back(relative(p, origin));
    }
    triangles_.reserve(mesh.triangles.size());
    for (const auto& t : mesh.triangles)
    {
      triangles_.push_back(makeTriangle(points[t[0]], points[t[1]], points[t[2]]));
    }
    this->buildTree(points, mesh);
  }
  ~EmbreeScene()
  {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  static Vector relative(const Point3& p, const Point3& origin)
  {
    return { static_cast<float>(p[0] - origin[0]), static_cast<float>(p[1] - origin[1]),
      static_cast<float>(p[2] - origin[2]) };
  }

  /// @param guess a triangle that may be near, or -1; the search looks for nearer ones only.
  Nearest closest(const Vector& query, std::int32_t guess) const
  {
    Nearest nearest{ triangles_.data(), query, std::numeric_limits<float>::infinity(), guess };
    if (guess >= 0)
    {
      nearest.squared = squaredDistance(triangles_[static_cast<std::size_t>(guess)], query);
    }
    RTCPointQuery sphere{ query.x, query.y, query.z, 0.0F, std::sqrt(nearest.squared) };
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(scene_, &sphere, &context, visitTriangle, &nearest);
    return nearest;
  }

private:
  void buildTree(const std::vector<Vector>& points, const TriangleMesh& mesh)
  {
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<Vector*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX,
      0, RTC_FORMAT_FLOAT3, sizeof(Vector), points.size()));
    std::copy(points.begin(), points.end(), corners);
    auto* ids = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
      RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& t : mesh.triangles)
    {
      ids = std::copy(t.begin(), t.end(), ids);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::vector<Triangle> triangles_;
};

} // namespace medial::benchmark::embree
