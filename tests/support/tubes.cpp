#include "support/tubes.h"

#include "support/transforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace medial::test
{
namespace
{

/// Negative inside.
double distanceTo(const Tube& tube, const Point3& x)
{
  Point3 along{};
  Point3 from{};
  double length = 0.0;
  double projection = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    along[i] = tube.to[i] - tube.from[i];
    from[i] = x[i] - tube.from[i];
    length += along[i] * along[i];
    projection += along[i] * from[i];
  }
  const double t = length > 0.0 ? std::clamp(projection / length, 0.0, 1.0) : 0.0;
  return std::hypot(from[0] - t * along[0], from[1] - t * along[1], from[2] - t * along[2]) -
    tube.radius;
}

/// Marching tetrahedra over a grid of cubes, each in six tetrahedra around its diagonal.
class Marcher
{
public:
  Marcher(const std::vector<Tube>& tubes, double spacing)
    : tubes_(tubes)
    , spacing_(spacing)
  {
    Point3 high{};
    for (int i = 0; i < 3; ++i)
    {
      double low = std::numeric_limits<double>::infinity();
      high[i] = -low;
      for (const Tube& tube : tubes)
      {
        low = std::min({ low, tube.from[i] - tube.radius, tube.to[i] - tube.radius });
        high[i] = std::max({ high[i], tube.from[i] + tube.radius, tube.to[i] + tube.radius });
      }
      origin_[i] = low - 1.3 * spacing;
      size_[i] = static_cast<int>(std::ceil((high[i] - origin_[i]) / spacing)) + 2;
    }
  }

  TriangleMesh march()
  {
    constexpr std::array<std::array<int, 3>, 6> kOrders{ { { 1, 2, 4 }, { 2, 1, 4 }, { 1, 4, 2 },
      { 4, 1, 2 }, { 2, 4, 1 }, { 4, 2, 1 } } };
    for (int z = 0; z + 1 < size_[2]; ++z)
    {
      for (int y = 0; y + 1 < size_[1]; ++y)
      {
        for (int x = 0; x + 1 < size_[0]; ++x)
        {
          for (const auto& order : kOrders)
          {
            std::array<Corner, 4> corners;
            int bits = 0;
            for (int c = 0; c < 4; ++c)
            {
              corners[c] = this->corner(x + (bits & 1), y + (bits >> 1 & 1), z + (bits >> 2));
              bits += c < 3 ? order[c] : 0;
            }
            this->cut(corners);
          }
        }
      }
    }
    return makeMesh(points_, triangles_);
  }

private:
  struct Corner
  {
    long long id;
    Point3 place;
    double value;
  };

  double value(const Point3& x) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Tube& tube : tubes_)
    {
      nearest = std::min(nearest, distanceTo(tube, x));
    }
    return nearest;
  }

  Corner corner(int x, int y, int z)
  {
    const long long id =
      x + static_cast<long long>(size_[0]) * (y + static_cast<long long>(size_[1]) * z);
    const Point3 place{ origin_[0] + spacing_ * x, origin_[1] + spacing_ * y,
      origin_[2] + spacing_ * z };
    const auto [entry, added] = values_.try_emplace(id, 0.0);
    if (added)
    {
      entry->second = this->value(place);
    }
    return { id, place, entry->second };
  }

  /// The point of the surface between two corners.
  int point(const Corner& a, const Corner& b)
  {
    const auto key = std::minmax(a.id, b.id);
    const auto [entry, added] =
      ids_.try_emplace({ key.first, key.second }, static_cast<int>(points_.size()));
    if (added)
    {
      const Corner& inner = a.value < 0.0 ? a : b;
      const Corner& outer = a.value < 0.0 ? b : a;
      double low = 0.0;
      double high = 1.0;
      const auto at = [&](double t)
      {
        Point3 x{};
        for (int i = 0; i < 3; ++i)
        {
          x[i] = inner.place[i] + t * (outer.place[i] - inner.place[i]);
        }
        return x;
      };
      for (int step = 0; step < 50; ++step)
      {
        const double middle = 0.5 * (low + high);
        (this->value(at(middle)) < 0.0 ? low : high) = middle;
      }
      points_.push_back(at(0.5 * (low + high)));
    }
    return entry->second;
  }

  void add(int a, int b, int c, const Point3& inside)
  {
    const Point3& p = points_[a];
    double volume = 0.0;
    Point3 u{};
    Point3 v{};
    Point3 w{};
    for (int i = 0; i < 3; ++i)
    {
      u[i] = points_[b][i] - p[i];
      v[i] = points_[c][i] - p[i];
      w[i] = inside[i] - p[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      volume += (u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]) * w[i];
    }
    triangles_.push_back({ a, volume < 0.0 ? b : c, volume < 0.0 ? c : b });
  }

  void cut(const std::array<Corner, 4>& corners)
  {
    std::vector<Corner> in;
    std::vector<Corner> out;
    for (const Corner& corner : corners)
    {
      (corner.value < 0.0 ? in : out).push_back(corner);
    }
    if (in.size() == 1)
    {
      this->add(this->point(in[0], out[0]), this->point(in[0], out[1]), this->point(in[0], out[2]),
        in[0].place);
    }
    else if (in.size() == 3)
    {
      this->add(this->point(in[0], out[0]), this->point(in[1], out[0]), this->point(in[2], out[0]),
        in[0].place);
    }
    else if (in.size() == 2)
    {
      const int a = this->point(in[0], out[0]);
      const int b = this->point(in[0], out[1]);
      const int c = this->point(in[1], out[1]);
      const int d = this->point(in[1], out[0]);
      this->add(a, b, c, in[0].place);
      this->add(a, c, d, in[1].place);
    }
  }

  const std::vector<Tube>& tubes_;
  double spacing_;
  Point3 origin_{};
  std::array<int, 3> size_{};
  std::map<long long, double> values_;
  std::map<std::pair<long long, long long>, int> ids_;
  std::vector<Point3> points_;
  std::vector<std::array<int, 3>> triangles_;
};

} // namespace

TriangleMesh unionOf(const std::vector<Tube>& tubes, double spacing)
{
  return Marcher(tubes, spacing).march();
}

TriangleMesh openTube(double radius, double height, int sides)
{
  const double step = 2.0 * std::acos(-1.0) / sides;
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < sides; ++i)
  {
    for (const double z : { -0.5 * height, 0.5 * height })
    {
      points.push_back({ radius * std::cos(i * step), radius * std::sin(i * step), z });
    }
    const int next = (i + 1) % sides;
    triangles.push_back({ 2 * i, 2 * next, 2 * next + 1 });
    triangles.push_back({ 2 * i, 2 * next + 1, 2 * i + 1 });
  }
  return makeMesh(points, triangles);
}

} // namespace medial::test
