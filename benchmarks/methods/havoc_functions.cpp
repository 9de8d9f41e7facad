#include "methods/havoc_functions.h"

#include "methods/slice_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

const double kRightAngle = std::acos(0.0);
/// A site nearer to the slice than this, in local units, is treated as if at this distance; its
/// function errs by no more than that.
constexpr double kMinHeight = 1e-3;
/// Share of the tolerance that the estimates of points' errors may use up.
constexpr double kSafety = 0.95;

/// Rounds up to one of the numbers 1 to 8, 10, 12, 14, 16, 20, ...
int roundedUp(double count)
{
  int power = 1;
  while (2 * power <= count)
  {
    power *= 2;
  }
  for (const int quarters : { 4, 5, 6, 7 })
  {
    const int candidate = (power * quarters + 3) / 4;
    if (candidate >= count)
    {
      return candidate;
    }
  }
  return 2 * power;
}

/// A segment from p to q seen from a slice. With x along its projection from p on and y across,
/// the squared distance from its line is w(x)^2 + y^2.
struct SegmentProjection
{
  SegmentProjection(const glm::dvec3& p, const glm::dvec3& q, double slice)
    : origin(p)
  {
    const glm::dvec3 u = glm::normalize(q - p);
    const double z = slice - p.z;
    level = std::hypot(u.x, u.y);
    slope = -u.z;
    height = level * z;
    along = level > 0.0 ? glm::dvec2(u) / level : glm::dvec2(1.0, 0.0);
    across = { -along.y, along.x };
    if (level > 0.0)
    {
      start = -u.z * z / level;
      end = (glm::distance(p, q) - u.z * z) / level;
    }
  }

  double w(double x) const { return height + slope * x; }
  /// Where the line meets the slice.
  double apex() const { return -height / slope; }

  glm::dvec2 origin, along, across;
  double level, slope, height;
  /// Of the strip between the planes across the ends.
  double start = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();
};

/// Builds the functions over one slice.
class FunctionBuilder
{
public:
  FunctionBuilder(const SiteSet& sites, const SiteBounds& bounds, const GridFrame& frame,
    const glm::ivec2& sliceSize, int slice, double tolerance)
    : sites_(sites)
    , bounds_(bounds)
    , frame_(frame)
    , last_(sliceSize - 1)
    , first_(frame.sample({ 0.0, 0.0, slice }))
    , tolerance_(tolerance)
  {
    const glm::dvec2 half = 0.5 * glm::dvec2(frame.step);
    const glm::dvec2 low = glm::dvec2(first_) - half;
    const glm::dvec2 high = glm::dvec2(first_) + glm::dvec2(last_) * glm::dvec2(frame.step) + half;
    corners_ = { low, { high.x, low.y }, high, { low.x, high.y } };
  }

  SliceFunctions build()
  {
    for (int face = 0; face < sites_.faceCount(); ++face)
    {
      if (sites_.active(face))
      {
        this->addFace(face);
      }
    }
    for (int edge = 0; edge < sites_.edgeCount(); ++edge)
    {
      if (sites_.active(sites_.firstEdge() + edge))
      {
        this->addSegment(edge);
      }
    }
    for (int vertex = 0; vertex < sites_.vertexCount(); ++vertex)
    {
      this->addPoint(vertex);
    }
    return std::move(functions_);
  }

private:
  /// The inside of a half-space, over grid points.
  Affine onSlice(const glm::dvec3& normal, double offset) const
  {
    const glm::vec2 gradient(normal * frame_.step);
    return { gradient.x, gradient.y, static_cast<float>(glm::dot(normal, first_) - offset) };
  }

  /// The part of the slice inside the first `count` half-spaces of a site.
  SlicePolygon prism(int site, int count) const
  {
    SlicePolygon polygon{ glm::vec2(last_) };
    bounds_.prepare(site);
    const HalfSpace* h = bounds_.begin(site);
    for (int i = 0; i < count && !polygon.empty(); ++i)
    {
      polygon.clip(this->onSlice(glm::dvec3(h[i]), static_cast<double>(h[i].w)), 0.0f);
    }
    return polygon;
  }

  void addFace(int face)
  {
    const SlicePolygon polygon = this->prism(face, 3);
    if (polygon.empty())
    {
      return;
    }
    const glm::dvec3& normal = sites_.faceNormal(face);
    const double offset = glm::dot(normal, sites_.points()[sites_.faces()[face].x]);
    this->addSide(face, polygon, this->onSlice(normal, offset));
    this->addSide(face, polygon, this->onSlice(-normal, -offset));
  }

  /// The part of the polygon where the distance from the face's plane is negative on this side.
  void addSide(int face, SlicePolygon polygon, const Affine& distance)
  {
    polygon.clip(distance, 0.0f);
    if (polygon.empty())
    {
      return;
    }
    polygon.snap();
    if (polygon.empty() || !polygon.coversGridPoint())
    {
      return;
    }
    const auto base = static_cast<std::uint32_t>(functions_.faceVertices.size());
    const int start = polygon.fanStart();
    for (int i = 0; i < polygon.size(); ++i)
    {
      const glm::vec2& corner = polygon.corner(start + i);
      functions_.faceVertices.push_back({ corner, std::abs(distance(corner)), face });
    }
    const auto count = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 2; i < count; ++i)
    {
      functions_.faceIndices.insert(functions_.faceIndices.end(), { base, base + i - 1, base + i });
    }
    functions_.area += polygon.area();
  }

  void addSegment(int edge)
  {
    const int site = sites_.firstEdge() + edge;
    const SlicePolygon strip = this->prism(site, 2);
    if (strip.empty())
    {
      return;
    }
    functions_.area += strip.area();
    const glm::dvec3& p = sites_.points()[sites_.edges()[edge].x];
    const glm::dvec3& q = sites_.points()[sites_.edges()[edge].y];
    const SegmentProjection segment(p, q, first_.z);
    double low = std::numeric_limits<double>::max();
    double high = -low;
    double reach = 0.0;
    for (const glm::dvec2& corner : corners_)
    {
      const glm::dvec2 offset = corner - segment.origin;
      low = std::min(low, glm::dot(offset, segment.along));
      high = std::max(high, glm::dot(offset, segment.along));
      reach = std::max(reach, std::abs(glm::dot(offset, segment.across)));
    }
    low = std::max(low, segment.start);
    high = std::min(high, segment.end);
    const double apex = segment.apex();
    if (low < apex && apex < high)
    {
      this->addHalfSheet(site, segment, low, apex, reach);
      this->addHalfSheet(site, segment, apex, high, reach);
    }
    else if (low < high)
    {
      this->addHalfSheet(site, segment, low, high, reach);
    }
  }

  /// Over the plane of (w, y) the function is a cone around the origin, linear along rays. Sectors
  /// between rays err by no more than the radius times (1 - cos of half their angle).
  void addHalfSheet(int site, const SegmentProjection& segment, double low, double high,
    double reach)
  {
    const bool rising = std::abs(segment.w(low)) <= std::abs(segment.w(high));
    const double from = rising ? low : high;
    const double to = rising ? high : low;
    const double max = std::max(std::abs(segment.w(to)), kMinHeight);
    double min = std::abs(segment.w(from));
    // Single precision could not tell them apart.
    min = max - min < kMinHeight ? max : min;
    const double radius = std::hypot(max, reach);
    const double sector = 2.0 * std::acos(std::max(0.0, 1.0 - tolerance_ / radius));
    const double angleTo = std::atan2(reach, max);
    const double angleFrom = std::atan2(reach, min);
    const double beyond = std::ceil((angleFrom - angleTo) / sector);
    const int sectors = roundedUp(std::ceil(angleTo / sector) + beyond);
    functions_.segments[sectors].push_back({ glm::vec2(segment.origin + from * segment.along),
      glm::vec2(segment.origin + to * segment.along), glm::vec2(segment.across),
      { static_cast<float>(min), static_cast<float>(max) }, static_cast<float>(reach),
      static_cast<float>(sectors - beyond), site });
  }

  /// The errors of rings and of sectors add up. That of rings is largest at the centre and falls
  /// off as height / distance; that of sectors grows from 0 at the centre. So their sum is largest
  /// either at the centre or at the outermost ring.
  void addPoint(int vertex)
  {
    const glm::dvec3& p = sites_.points()[vertex];
    const double height = std::max(std::abs(first_.z - p.z), kMinHeight);
    double radius = 0.0;
    for (const glm::dvec2& corner : corners_)
    {
      radius = std::max(radius, glm::distance(corner, glm::dvec2(p)));
    }
    const double farthest = std::hypot(radius, height);
    const double fallOff = height / farthest;
    const double tolerance = kSafety * tolerance_;
    const double ringError = tolerance * std::min(1.0, 0.5 / fallOff);
    const double sectorError = tolerance - fallOff * ringError;
    // Chords of the hyperbola whose ends differ by t in asinh(r / height) err by
    // height (cosh(t / 2) - 1) at most.
    const double step = 2.0 * std::acosh(1.0 + ringError / height);
    // At the middle of a sector's outer edge, `radius` from the centre, the depth is that at its
    // ends, radius / cosine from the centre.
    const double allowed = farthest + sectorError;
    const double cosine = radius / std::sqrt(allowed * allowed - height * height);
    const int sectors = std::max(4, roundedUp(2.0 * kRightAngle / std::acos(cosine)));
    const double outer = radius / std::cos(2.0 * kRightAngle / sectors);
    const double growth = std::asinh(outer / height);
    const int rings = roundedUp(std::ceil(growth / step));
    functions_.points[{ rings, sectors }].push_back({ glm::vec2(p), static_cast<float>(height),
      static_cast<float>(growth), sites_.firstVertex() + vertex });
    functions_.area += static_cast<double>(last_.x + 1) * (last_.y + 1);
  }

  const SiteSet& sites_;
  const SiteBounds& bounds_;
  const GridFrame& frame_;
  glm::ivec2 last_;
  glm::dvec3 first_; ///< position of the slice's first grid point
  double tolerance_;
  std::array<glm::dvec2, 4> corners_; ///< of the slice
  SliceFunctions functions_;
};

} // namespace

SliceFunctions sliceFunctions(const SiteSet& sites, const SiteBounds& bounds,
  const GridFrame& frame, const glm::ivec2& sliceSize, int slice, double tolerance)
{
  return FunctionBuilder(sites, bounds, frame, sliceSize, slice, tolerance).build();
}

} // namespace medial::benchmark
