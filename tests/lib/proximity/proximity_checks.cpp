#include "lib/proximity/proximity_checks.h"

#include "lib/proximity/proximity_oracle.h"
#include "support/brute_force.h"
#include "support/point_math.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace medial::test
{
namespace
{

constexpr double kDiagonal = 2.0;
constexpr double kOnSurface = 1e-9 * kDiagonal;

Point3 scaledBy(double factor, const Point3& p)
{
  return { factor * p[0], factor * p[1], factor * p[2] };
}

/// Zero of either sign is the same, and so is any NaN.
bool areSame(double a, double b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

void expectSameContact(const ProximityContact& a, const ProximityContact& b)
{
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.manifold, b.manifold);
  EXPECT_EQ(a.cellA, b.cellA);
  EXPECT_EQ(a.cellB, b.cellB);
}

/// Whether one of two surfaces that do not intersect has points inside the other.
bool isAnyInside(const TriangleMesh& mesh, const SolidOracle& solid)
{
  return std::any_of(mesh.points.begin(), mesh.points.end(),
    [&](const Point3& point) { return solid.contains(point); });
}

void checkWitnesses(const TriangleMesh& a, const TriangleMesh& b, const Proximity& found,
  ProximityErrors& errors)
{
  errors.witnesses =
    std::max({ distanceToCell(a, found.cellA, found.witnessA),
      distanceToCell(b, found.cellB, found.witnessB),
      std::abs(length(minus(found.witnessA, found.witnessB)) - found.separation) }) /
    kDiagonal;
}

void checkPointDepths(const std::vector<PointDepth>& expected, const std::vector<PointDepth>& found,
  ProximityErrors& errors)
{
  const auto samePoint = [](const PointDepth& a, const PointDepth& b)
  { return a.point == b.point; };
  if (!std::equal(expected.begin(), expected.end(), found.begin(), found.end(), samePoint))
  {
    errors.wrongPoints = 1;
    return;
  }
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    const double error = std::abs(expected[i].depth - found[i].depth) / kDiagonal;
    errors.pointDepths = std::max(errors.pointDepths, error);
  }
}

/// The depth of a point that is on one of the surfaces; 0 if it is on none or outside.
double depthAt(const Point3& point, const SolidOracle& a, const SolidOracle& b)
{
  const double toA = a.distanceTo(point);
  const double toB = b.distanceTo(point);
  const Point3 near = snapped(point);
  const double inB = toA <= kOnSurface && b.contains(near) ? toB : 0.0;
  const double inA = toB <= kOnSurface && a.contains(near) ? toA : 0.0;
  return std::max(inA, inB);
}

/// Whether closed meshes intersect or one has points inside the other.
bool overlap(const TriangleMesh& a, const TriangleMesh& b)
{
  return surfacesIntersect(a, b) || isAnyInside(a, SolidOracle(b)) ||
    isAnyInside(b, SolidOracle(a));
}

/// Whether a translation of a length and any of some directions, of which `first` is one,
/// separates.
bool doesAnySeparate(const TriangleMesh& a, const TriangleMesh& b, double size, const Point3& first)
{
  const RigidMotion directions = RandomMotions(7).rotation();
  for (const Point3& direction :
    { first, directions.rows[0], directions.rows[1], directions.rows[2] })
  {
    if (!overlap(snapped(translated(a, scaledBy(size / length(direction), direction))), b))
    {
      return true;
    }
  }
  return false;
}

void checkTranslation(const TriangleMesh& a, const TriangleMesh& b, const Proximity& found,
  const ProximityChecks& checks, ProximityErrors& errors)
{
  const auto& [lower, upper] = found.translationalDepth;
  const Point3& translation = found.separatingTranslation;
  errors.checkedBounds = 1;
  constexpr double kLittle = 1e-6;
  const bool isAsLong = std::abs(length(translation) - upper) <= 1e-12 * kDiagonal;
  const bool separates =
    isAsLong && !overlap(snapped(translated(a, scaledBy(1.0 + kLittle, translation))), b);
  errors.notSeparated = separates ? 0 : 1;
  errors.lowerAbove = std::max(0.0, lower - upper) / kDiagonal;
  if (checks.convex)
  {
    const double truth = convexTranslationalDepth(a, b);
    errors.lowerAbove = std::max(0.0, lower - truth) / kDiagonal;
    errors.upperBelow = std::max(0.0, truth - upper) / kDiagonal;
    errors.width = (upper - lower) / kDiagonal;
    return;
  }
  if (checks.sampled && doesAnySeparate(a, b, (1.0 - kLittle) * lower, translation))
  {
    errors.tooHighLower = 1;
  }
}

void checkDepths(const TriangleMesh& a, const TriangleMesh& b, const Proximity& found,
  const ProximityChecks& checks, ProximityErrors& errors)
{
  const SolidOracle solidA(a);
  const SolidOracle solidB(b);
  checkPointDepths(solidB.depthsOf(a), found.depthsOfA, errors);
  checkPointDepths(solidA.depthsOf(b), found.depthsOfB, errors);
  if (found.depth > 0.0)
  {
    const double excess = found.depth - depthAt(found.deepestPoint, solidA, solidB);
    errors.depthAbove = std::max(0.0, excess) / kDiagonal;
  }
  if (checks.sampled)
  {
    constexpr int kPerSide = 5;
    const double sampled =
      std::max(solidB.sampledDepthOf(a, kPerSide), solidA.sampledDepthOf(b, kPerSide));
    // Of depths that are small beside the meshes this much may be missing in any case.
    const double allowed = 1e-5 * std::min(a.bounds().diagonal(), b.bounds().diagonal());
    const double missing = sampled - found.depth - allowed;
    errors.depthBelow = missing > 0.0 ? missing / sampled : 0.0;
    const double beyond = sampled - found.depthAtMost;
    errors.depthBeyond = beyond > 0.0 ? beyond / sampled : 0.0;
  }
}

} // namespace

Point3 RigidMotion::of(const Point3& point) const
{
  return { dot(rows[0], point) + translation[0], dot(rows[1], point) + translation[1],
    dot(rows[2], point) + translation[2] };
}

RigidMotion RandomMotions::rotation()
{
  std::array<double, 4> q{ this->normal(), this->normal(), this->normal(), this->normal() };
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& x : q)
  {
    x /= size;
  }
  const auto& [w, x, y, z] = q;
  RigidMotion motion;
  motion.rows = { Point3{ 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y) },
    Point3{ 2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x) },
    Point3{ 2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y) } };
  return motion;
}

RigidMotion RandomMotions::motion(double reach)
{
  RigidMotion motion = this->rotation();
  const double distance = reach * std::uniform_real_distribution<double>(0.0, 1.0)(random_);
  motion.translation = scaledBy(distance, this->rotation().rows[0]);
  return motion;
}

TriangleMesh moved(TriangleMesh mesh, const RigidMotion& motion)
{
  for (Point3& point : mesh.points)
  {
    point = motion.of(point);
  }
  return mesh;
}

TriangleMesh normalised(TriangleMesh mesh)
{
  const Bounds bounds = mesh.bounds();
  Point3 centre;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    centre[axis] = -0.5 * (bounds.min[axis] + bounds.max[axis]);
  }
  return scaled(translated(std::move(mesh), centre), kDiagonal / bounds.diagonal());
}

Proximity mirrored(Proximity proximity)
{
  std::swap(proximity.witnessA, proximity.witnessB);
  std::swap(proximity.cellA, proximity.cellB);
  std::swap(proximity.depthsOfA, proximity.depthsOfB);
  proximity.separatingTranslation = scaledBy(-1.0, proximity.separatingTranslation);
  for (ProximityContact& contact : proximity.contacts)
  {
    contact.normal = scaledBy(-1.0, contact.normal);
    std::swap(contact.cellA, contact.cellB);
  }
  return proximity;
}

void expectSame(const Proximity& a, const Proximity& b)
{
  EXPECT_TRUE(areSame(a.separation, b.separation)) << a.separation << ' ' << b.separation;
  EXPECT_EQ(a.witnessA, b.witnessA);
  EXPECT_EQ(a.witnessB, b.witnessB);
  EXPECT_EQ(a.cellA, b.cellA);
  EXPECT_EQ(a.cellB, b.cellB);
  EXPECT_EQ(a.intersect, b.intersect);
  EXPECT_EQ(a.collide, b.collide);
  EXPECT_EQ(a.insideUndefined, b.insideUndefined);
  EXPECT_TRUE(areSame(a.depth, b.depth)) << a.depth << ' ' << b.depth;
  EXPECT_TRUE(areSame(a.depthAtMost, b.depthAtMost)) << a.depthAtMost << ' ' << b.depthAtMost;
  if (a.depth > 0.0)
  {
    EXPECT_EQ(a.deepestPoint, b.deepestPoint);
  }
  EXPECT_EQ(a.translationalDepth.lower, b.translationalDepth.lower);
  EXPECT_EQ(a.translationalDepth.upper, b.translationalDepth.upper);
  EXPECT_EQ(a.separatingTranslation, b.separatingTranslation);
  const auto same = [](const PointDepth& p, const PointDepth& q)
  { return p.point == q.point && p.depth == q.depth; };
  EXPECT_TRUE(std::equal(a.depthsOfA.begin(), a.depthsOfA.end(), b.depthsOfA.begin(),
    b.depthsOfA.end(), same));
  EXPECT_TRUE(std::equal(a.depthsOfB.begin(), a.depthsOfB.end(), b.depthsOfB.begin(),
    b.depthsOfB.end(), same));
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i)
  {
    expectSameContact(a.contacts[i], b.contacts[i]);
  }
}

void ProximityErrors::add(const ProximityErrors& other)
{
  poses += other.poses;
  intersecting += other.intersecting;
  contained += other.contained;
  wrongIntersect += other.wrongIntersect;
  wrongCollide += other.wrongCollide;
  wrongPoints += other.wrongPoints;
  checkedBounds += other.checkedBounds;
  tooHighLower += other.tooHighLower;
  notSeparated += other.notSeparated;
  const auto keepMax = [](double& mine, double theirs) { mine = std::max(mine, theirs); };
  keepMax(separation, other.separation);
  keepMax(witnesses, other.witnesses);
  keepMax(pointDepths, other.pointDepths);
  keepMax(depthBelow, other.depthBelow);
  keepMax(depthBeyond, other.depthBeyond);
  keepMax(depthAbove, other.depthAbove);
  keepMax(lowerAbove, other.lowerAbove);
  keepMax(upperBelow, other.upperBelow);
  keepMax(width, other.width);
}

std::string ProximityErrors::describe() const
{
  std::ostringstream text;
  text << poses << " poses, " << intersecting << " intersect, " << contained
       << " contain; wrong: " << wrongIntersect << " intersect, " << wrongCollide << " collide, "
       << wrongPoints << " points inside; errors: separation " << separation << ", witnesses "
       << witnesses << ", point depths " << pointDepths << ", depth below " << depthBelow
       << ", above " << depthAbove << "; " << checkedBounds << " translational depths, lower above "
       << lowerAbove << ", upper below " << upperBelow << ", width " << width << ", not separated "
       << notSeparated;
  return text.str();
}

ProximityErrors errorsOf(const TriangleMesh& a, const TriangleMesh& b, const Proximity& found,
  const ProximityChecks& checks)
{
  ProximityErrors errors;
  errors.poses = 1;
  const bool intersecting = surfacesIntersect(a, b);
  const bool contained = !intersecting && overlap(a, b);
  errors.intersecting = intersecting ? 1 : 0;
  errors.contained = contained ? 1 : 0;
  errors.wrongIntersect = found.intersect != intersecting ? 1 : 0;
  errors.wrongCollide = found.collide != (intersecting || contained) ? 1 : 0;
  const double separation = intersecting ? 0.0 : surfaceSeparation(a, b);
  errors.separation = std::abs(found.separation - separation) / kDiagonal;
  if ((found.separation == 0.0) != intersecting)
  {
    errors.wrongIntersect = 1;
  }
  checkWitnesses(a, b, found, errors);
  checkDepths(a, b, found, checks, errors);
  if (found.collide)
  {
    checkTranslation(a, b, found, checks, errors);
  }
  return errors;
}

void expectRight(const ProximityErrors& errors)
{
  EXPECT_EQ(errors.wrongIntersect, 0);
  EXPECT_EQ(errors.wrongCollide, 0);
  EXPECT_EQ(errors.wrongPoints, 0);
  EXPECT_LE(errors.separation, 1e-9);
  EXPECT_LE(errors.witnesses, 1e-9);
  EXPECT_LE(errors.pointDepths, 1e-9);
  EXPECT_LE(errors.depthBelow, ProximityOptions().depthTolerance);
  EXPECT_LE(errors.depthBeyond, 1e-9);
  EXPECT_LE(errors.depthAbove, 1e-9);
  EXPECT_LE(errors.lowerAbove, 1e-9);
  EXPECT_LE(errors.upperBelow, 1e-9);
  EXPECT_LE(errors.width, 1e-8);
  EXPECT_EQ(errors.tooHighLower, 0);
  EXPECT_EQ(errors.notSeparated, 0);
}

} // namespace medial::test
