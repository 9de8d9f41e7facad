#include "methods/slice_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

/// Adding and subtracting this rounds much smaller numbers to multiples of 1/256, which are
/// OpenGL's usual 8 subpixel bits.
constexpr float kSubpixelRounding = 49152.0f;
/// A fan whose lowest triangle is at least this high, in square pixels, is good enough.
constexpr float kGoodSquaredHeight = 0.05f * 0.05f;

float cross(const glm::vec2& u, const glm::vec2& v)
{
  return u.x * v.y - u.y * v.x;
}

/// Returns the squared height of a triangle over its longest edge.
float squaredHeight(const glm::vec2& p, const glm::vec2& q, const glm::vec2& r)
{
  const glm::vec2 u = q - p;
  const glm::vec2 v = r - p;
  const float longest = std::max({ glm::dot(u, u), glm::dot(v, v), glm::dot(v - u, v - u) });
  const float twiceArea = cross(u, v);
  return twiceArea * twiceArea / longest;
}

} // namespace

SlicePolygon::SlicePolygon(const glm::vec2& last)
  : size_(4)
{
  corners_[0] = { -0.5f, -0.5f };
  corners_[1] = { last.x + 0.5f, -0.5f };
  corners_[2] = { last.x + 0.5f, last.y + 0.5f };
  corners_[3] = { -0.5f, last.y + 0.5f };
}

void SlicePolygon::clip(const Affine& side, float limit)
{
  std::array<float, kMaxCorners> values;
  bool cuts = false;
  for (int i = 0; i < size_; ++i)
  {
    values[i] = side(corners_[i]) - limit;
    cuts = cuts || values[i] > 0.0f;
  }
  if (!cuts)
  {
    return;
  }
  // After rounding, more than two edges may cross the line.
  int count = 0;
  for (int i = 0; i < size_; ++i)
  {
    const int next = i + 1 == size_ ? 0 : i + 1;
    count += (values[i] <= 0.0f ? 1 : 0) + ((values[i] <= 0.0f) != (values[next] <= 0.0f) ? 1 : 0);
  }
  if (count > kMaxCorners)
  {
    return;
  }
  std::array<glm::vec2, kMaxCorners> kept;
  count = 0;
  for (int i = 0; i < size_; ++i)
  {
    const int next = i + 1 == size_ ? 0 : i + 1;
    if (values[i] <= 0.0f)
    {
      kept[count++] = corners_[i];
    }
    if ((values[i] <= 0.0f) != (values[next] <= 0.0f))
    {
      const float t = values[i] / (values[i] - values[next]);
      kept[count++] = corners_[i] + t * (corners_[next] - corners_[i]);
    }
  }
  std::copy_n(kept.begin(), count, corners_.begin());
  size_ = count;
}

void SlicePolygon::snap()
{
  int count = 0;
  for (int i = 0; i < size_; ++i)
  {
    const glm::vec2 snapped = (corners_[i] + kSubpixelRounding) - kSubpixelRounding;
    if (count == 0 || snapped != corners_[count - 1])
    {
      corners_[count++] = snapped;
    }
  }
  while (count > 1 && corners_[count - 1] == corners_[0])
  {
    --count;
  }
  size_ = count;
}

int SlicePolygon::fanStart() const
{
  int best = 0;
  float highest = -1.0f;
  for (int start = 0; start < size_ && highest < kGoodSquaredHeight; ++start)
  {
    const float min = this->minFanHeight(start);
    if (min > highest)
    {
      highest = min;
      best = start;
    }
  }
  return best;
}

float SlicePolygon::minFanHeight(int start) const
{
  float min = std::numeric_limits<float>::max();
  for (int i = 1; i + 1 < size_; ++i)
  {
    min = std::min(min,
      squaredHeight(this->corner(start), this->corner(start + i), this->corner(start + i + 1)));
  }
  return min;
}

bool SlicePolygon::coversGridPoint() const
{
  glm::vec2 low = corners_[0];
  glm::vec2 high = low;
  for (int i = 1; i < size_; ++i)
  {
    low = glm::min(low, corners_[i]);
    high = glm::max(high, corners_[i]);
  }
  return std::floor(high.x) >= low.x && std::floor(high.y) >= low.y;
}

double SlicePolygon::area() const
{
  double twice = 0.0;
  for (int i = 2; i < size_; ++i)
  {
    twice += static_cast<double>(cross(corners_[i - 1] - corners_[0], corners_[i] - corners_[0]));
  }
  return 0.5 * std::abs(twice);
}

} // namespace medial::benchmark
