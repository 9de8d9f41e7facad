#pragma once

#include "medial/proximity.h"
#include "proximity/minkowski_depth.h"
#include "proximity/moving_mesh.h"
#include "proximity/penetration.h"
#include "proximity/solid_query.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// Bounds the length of the shortest translation that separates two solids that collide.
///
/// From below: a ball inside A and a ball inside B with the same centre have to come apart, so the
/// sum of their radii is a bound; for convex meshes the Minkowski difference gives the length
/// itself. From above: translations along which the last contact is known, improved by turning them
/// towards the normal there, as Je et al. (PolyDepth, 2012) do.
class TranslationalDepth
{
public:
  TranslationalDepth(const MovingMesh& a, const MovingMesh& b, const SolidQuery& solidA,
    const SolidQuery& solidB)
    : a_(a)
    , b_(b)
    , solidA_(solidA)
    , solidB_(solidB)
    , minkowski_(a, b)
  {
  }

  /// @param directions along which A may leave B, unit vectors.
  /// @param[out] translation of A that was verified to separate the solids.
  DepthBounds find(const DeepPlace& deepest, const std::vector<glm::dvec3>& directions,
    glm::dvec3& translation);

private:
  /// A translation of A.
  struct Exit
  {
    glm::dvec3 direction{ 0.0 };
    double length = 0.0;
    glm::dvec3 normal{ 0.0 }; ///< of the surfaces where they touch last
  };
  /// A position and one of the surfaces.
  struct Nearness
  {
    double depth = 0.0; ///< distance, negative outside
    int slot = -1;      ///< of the closest element
  };
  /// A box in which the balls' common centre may be.
  struct Part
  {
    Box box;
    double max;   ///< no sum of radii in it is larger
    Nearness toA; ///< of the centre of the box; 0 if that is not known
    Nearness toB;

    glm::dvec3 centre() const { return 0.5 * (box.min + box.max); }
    double sumOfDepths() const { return toA.depth + toB.depth; }
  };

  /// @param[out] hullLower the lower bound for two convex meshes; 0 for others.
  Exit findExit(const std::vector<glm::dvec3>& directions, double& hullLower);
  /// Lengthens an exit until the exact tests find that it separates; false if it does not.
  bool lengthen(const Exit& exit, double size, double& length, glm::dvec3& translation) const;
  /// The shortest way out of the bounding boxes.
  Exit boxExit() const;
  void tryDirection(const glm::dvec3& direction, Exit& best) const;
  /// Turns the direction towards the normal of the last contact, as long as that is shorter.
  void turn(Exit& best) const;
  /// Returns a sum of radii of balls with a common centre.
  /// @param enough where the search ends.
  double commonBalls(const DeepPlace& deepest, double enough);
  std::array<Part, 2> halve(const Part& part) const;
  /// Finds how near the halves of a part are to a mesh.
  static void findNearness(const MovingMesh& mesh, const SolidQuery& solid,
    std::array<Part, 2>& halves, double moved, Nearness Part::*nearness);
  bool separates(const glm::dvec3& translation) const;

  const MovingMesh& a_;
  const MovingMesh& b_;
  const SolidQuery& solidA_;
  const SolidQuery& solidB_;
  MinkowskiDepth minkowski_;
  std::vector<Part> parts_; ///< a heap
};

} // namespace medial
