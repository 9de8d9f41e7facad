#pragma once

#include "medial/proximity.h"
#include "medial/triangle_mesh.h"

#include <array>
#include <cstdint>
#include <random>
#include <string>

namespace medial::test
{

/// A rotation about the origin, and then a translation.
struct RigidMotion
{
  std::array<Point3, 3> rows{ Point3{ 1, 0, 0 }, Point3{ 0, 1, 0 }, Point3{ 0, 0, 1 } };
  Point3 translation{};

  Point3 of(const Point3& point) const;
};

/// Uniformly random rotations; the same for the same seed.
class RandomMotions
{
public:
  explicit RandomMotions(std::uint32_t seed)
    : random_(seed)
  {
  }

  RigidMotion rotation();
  /// A rotation, and a translation of at most `reach` in any direction.
  RigidMotion motion(double reach);

private:
  double normal() { return normal_(random_); }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

TriangleMesh moved(TriangleMesh mesh, const RigidMotion& motion);

/// Centred at the origin, with bounds of diagonal 2.
TriangleMesh normalised(TriangleMesh mesh);

/// The answer for B and A.
Proximity mirrored(Proximity proximity);

/// Expects equal answers to the last bit, but for the time that they took.
void expectSame(const Proximity& a, const Proximity& b);

/// How answers for poses of a pair differ from the oracle. Lengths are parts of a mesh's diagonal.
struct ProximityErrors
{
  int poses = 0;
  int intersecting = 0;
  int contained = 0; ///< that collide without intersecting
  int wrongIntersect = 0;
  int wrongCollide = 0;
  int wrongPoints = 0; ///< poses with other points inside
  double separation = 0.0;
  double witnesses = 0.0; ///< how far they are from the surfaces, or not at the separation
  double pointDepths = 0.0;
  double depthBelow = 0.0;  ///< part of a sampled depth that is missing
  double depthBeyond = 0.0; ///< part of a sampled depth that is above what the depth is at most
  double depthAbove = 0.0;  ///< what is more than the depth at the deepest point
  int checkedBounds = 0;    ///< of the translational depth
  double lowerAbove = 0.0;  ///< how far the lower bound is above the oracle's, or the upper one
  double upperBelow = 0.0;  ///< how far the upper bound is below the oracle's; of convex pairs only
  double width = 0.0;       ///< between the bounds; of convex pairs only
  int tooHighLower = 0;     ///< a shorter translation separates; of pairs that are not convex only
  int notSeparated = 0;     ///< by the translation, stretched by 1e-6

  void add(const ProximityErrors& other);
  std::string describe() const;
};

/// What is checked beside collisions and separation.
struct ProximityChecks
{
  bool convex = false;
  bool sampled = false; ///< whether to look for deeper places and for shorter translations
};

/// Checks an answer of default options for two closed meshes from snapped() that face outwards and
/// have a diagonal of about 2.
ProximityErrors errorsOf(const TriangleMesh& a, const TriangleMesh& b, const Proximity& found,
  const ProximityChecks& checks);

/// Nothing wrong, and errors within the tolerances.
void expectRight(const ProximityErrors& errors);

} // namespace medial::test
