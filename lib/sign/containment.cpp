#include "sign/containment.h"

#include "sign/line_crossing.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Points sorted into the squares of a raster over y and z, for the lines along x through them.
class PointRaster
{
public:
  explicit PointRaster(const std::vector<glm::dvec3>& points)
    : size_(std::clamp(static_cast<int>(std::sqrt(points.size())), 1, kMaxSize))
    , squares_(static_cast<std::size_t>(size_) * size_)
  {
    glm::dvec2 high(-HUGE_VAL);
    low_ = glm::dvec2(HUGE_VAL);
    for (const glm::dvec3& point : points)
    {
      low_ = glm::min(low_, glm::dvec2(point.y, point.z));
      high = glm::max(high, glm::dvec2(point.y, point.z));
    }
    step_ = glm::max((high - low_) / static_cast<double>(size_), glm::dvec2(1e-300));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const glm::ivec2 square = this->squareOf(glm::dvec2(points[i].y, points[i].z));
      squares_[square.y * size_ + square.x].push_back(static_cast<int>(i));
    }
  }

  /// Calls visit(point) for all points whose square meets the rectangle.
  template <typename Visit>
  void visit(const glm::dvec2& low, const glm::dvec2& high, const Visit& visit) const
  {
    const glm::ivec2 first = this->squareOf(low);
    const glm::ivec2 last = this->squareOf(high);
    for (int j = first.y; j <= last.y; ++j)
    {
      for (int i = first.x; i <= last.x; ++i)
      {
        for (const int point : squares_[j * size_ + i])
        {
          visit(point);
        }
      }
    }
  }

private:
  static constexpr int kMaxSize = 1024;

  glm::ivec2 squareOf(const glm::dvec2& point) const
  {
    return glm::ivec2(glm::clamp((point - low_) / step_, glm::dvec2(0.0), glm::dvec2(size_ - 1)));
  }

  int size_;
  glm::dvec2 low_;
  glm::dvec2 step_;
  std::vector<std::vector<int>> squares_;
};

} // namespace

Containment::Containment(const std::vector<SolidTriangle>& triangles,
  std::vector<glm::dvec3> points)
  : windings_(points.size())
{
  const PointRaster raster(points);
  for (const SolidTriangle& triangle : triangles)
  {
    const auto& [a, b, c] = triangle.corners;
    const glm::dvec3 low = glm::min(a, glm::min(b, c));
    const glm::dvec3 high = glm::max(a, glm::max(b, c));
    raster.visit(glm::dvec2(low.y, low.z), glm::dvec2(high.y, high.z),
      [&](int point)
      {
        const glm::dvec3& p = points[point];
        const auto segment = cutAt(triangle.corners, p.z);
        const auto crossing = segment ? crossLine(*segment, p.y) : std::nullopt;
        if (crossing && crossing->x < p.x)
        {
          windings_[point][triangle.solid] += crossing->direction * triangle.weight;
        }
      });
  }
}

} // namespace medial
