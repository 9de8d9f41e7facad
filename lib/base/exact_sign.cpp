#include "base/exact_sign.h"

#include <array>
#include <cmath>

// Compiled without fused operations but for std::fma: what they would change are the errors of
// sums and products, which are computed here.
namespace medial::exact
{
namespace
{

/// A rounded result and what rounding took away: their sum is exact.
struct Rounded
{
  double value;
  double error;
};

Rounded sumOf(double a, double b)
{
  const double value = a + b;
  const double partOfB = value - a;
  const double partOfA = value - partOfB;
  return { value, (a - partOfA) + (b - partOfB) };
}

Rounded productOf(double a, double b)
{
  const double value = a * b;
  return { value, std::fma(a, b, -value) };
}

/// A number as the exact sum of parts that do not overlap, by ascending magnitude and without
/// zeros: Shewchuk's strongly nonoverlapping expansions.
template <int Capacity>
class Expansion
{
public:
  Expansion() = default;
  explicit Expansion(const Rounded& rounded)
  {
    append(rounded.error);
    append(rounded.value);
  }

  int size() const { return size_; }
  double operator[](int i) const { return parts_[i]; }

  void append(double part)
  {
    if (part != 0.0)
    {
      parts_[size_++] = part;
    }
  }

  Expansion operator-() const
  {
    Expansion negated;
    for (int i = 0; i < size_; ++i)
    {
      negated.append(-parts_[i]);
    }
    return negated;
  }

  /// The greatest part outweighs the others.
  int sign() const { return size_ == 0 ? 0 : parts_[size_ - 1] > 0.0 ? 1 : -1; }

  double rounded() const
  {
    double sum = 0.0;
    for (int i = 0; i < size_; ++i)
    {
      sum += parts_[i];
    }
    return sum;
  }

private:
  int size_ = 0;
  std::array<double, Capacity> parts_; // of which the first size_ are set
};

/// Shewchuk's fast expansion sum: adds the parts of both by ascending magnitude.
template <int M, int N>
Expansion<M + N> operator+(const Expansion<M>& e, const Expansion<N>& f)
{
  Expansion<M + N> sum;
  double carried = 0.0;
  for (int i = 0, j = 0; i < e.size() || j < f.size();)
  {
    const bool fromE = j == f.size() || (i < e.size() && std::abs(e[i]) < std::abs(f[j]));
    const Rounded added = sumOf(carried, fromE ? e[i++] : f[j++]);
    sum.append(added.error);
    carried = added.value;
  }
  sum.append(carried);
  return sum;
}

/// Shewchuk's scaled expansion.
template <int N>
Expansion<2 * N> scaled(const Expansion<N>& e, double factor)
{
  Expansion<2 * N> product;
  double carried = 0.0;
  for (int i = 0; i < e.size(); ++i)
  {
    const Rounded part = productOf(e[i], factor);
    const Rounded low = sumOf(carried, part.error);
    const Rounded high = sumOf(part.value, low.value);
    product.append(low.error);
    product.append(high.error);
    carried = high.value;
  }
  product.append(carried);
  return product;
}

using Difference = Expansion<2>;

template <int N>
Expansion<4 * N> operator*(const Expansion<N>& e, const Difference& f)
{
  switch (f.size())
  {
    case 0:
      return {};
    case 1:
      return Expansion<2 * N>() + scaled(e, f[0]);
    default:
      return scaled(e, f[0]) + scaled(e, f[1]);
  }
}

Difference differenceOf(double a, double b)
{
  return Difference(sumOf(a, -b));
}

/// The determinant of (p, q) and (r, s).
Expansion<16> minorOf(const Difference& p, const Difference& q, const Difference& r,
  const Difference& s)
{
  return p * s + -(q * r);
}

struct Vector
{
  Vector(const glm::dvec3& from, const glm::dvec3& to)
    : x(differenceOf(to.x, from.x))
    , y(differenceOf(to.y, from.y))
    , z(differenceOf(to.z, from.z))
  {
  }

  Difference x;
  Difference y;
  Difference z;
};

Expansion<192> exactDeterminant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  const glm::dvec3& d)
{
  const Vector u(d, a);
  const Vector v(d, b);
  const Vector w(d, c);
  return minorOf(v.y, v.z, w.y, w.z) * u.x + minorOf(v.z, v.x, w.z, w.x) * u.y +
    minorOf(v.x, v.y, w.x, w.y) * u.z;
}

} // namespace

int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
{
  // Meshes that touch often share vertices.
  if (a == d || b == d || c == d || a == b || a == c || b == c)
  {
    return 0;
  }
  return exactDeterminant(a, b, c, d).sign();
}

int orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
  const Difference ux = differenceOf(a.x, c.x);
  const Difference uy = differenceOf(a.y, c.y);
  const Difference vx = differenceOf(b.x, c.x);
  const Difference vy = differenceOf(b.y, c.y);
  return minorOf(ux, uy, vx, vy).sign();
}

double determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
  const glm::dvec3& d)
{
  return exactDeterminant(a, b, c, d).rounded();
}

} // namespace medial::exact
