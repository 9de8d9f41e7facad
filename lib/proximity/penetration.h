#pragma once

#include "proximity/closest_element.h"
#include "proximity/enclosed_points.h"
#include "proximity/moving_mesh.h"
#include "proximity/solid_query.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// A place of a surface inside another solid.
struct DeepPlace
{
  const MovingMesh* mesh = nullptr; ///< whose surface it is
  double depth = 0.0;               ///< distance to the other surface
  glm::dvec3 point{ 0.0 };
  glm::dvec3 closest{ 0.0 }; ///< on the other surface
  int slot = -1;             ///< of the surface's element
  int otherSlot = -1;        ///< of the other surface's
};

/// A place where a triangle is cut.
struct CutPlace
{
  int slot;
  int pair;     ///< of elements that intersect, by number
  int crossing; ///< of this pair, by number
  glm::dvec3 point;
};

/// How deep the surface of one mesh is inside the solid of another (section 6 of the paper: the
/// distance field of the other at the surface's points, and its maximum).
class Penetration
{
public:
  Penetration(const MovingMesh& mesh, const MovingMesh& other, const SolidQuery& solid)
    : mesh_(mesh)
    , other_(other)
    , solid_(solid)
  {
  }

  /// Finds the points inside and their depths. Uses the threads of the current arena.
  /// @param cut slots of the elements that intersect the other mesh, ascending.
  /// @param depths whether to find the depths.
  void find(const std::vector<int>& cut, bool depths);

  /// Returns the deepest of the points.
  DeepPlace deepestPoint() const;
  const EnclosedPoints& enclosed() const { return enclosed_; }
  /// Per enclosed point: what of the other surface is closest.
  const std::vector<ClosestElement>& closest() const { return closest_; }
  double depthOf(std::size_t enclosed) const;
  DeepPlace placeOf(std::size_t enclosed) const;

  /// Returns the deepest place of the surface, up to a tolerance, or a known one if that is deeper.
  /// @param cut as for find().
  /// @param crossings where these elements are cut, by ascending slots: between two of them a
  ///   triangle is deep, however thin the overlap.
  /// @param relative, absolute how far the depth may be below the largest.
  DeepPlace deepest(const std::vector<int>& cut, const std::vector<CutPlace>& crossings,
    const DeepPlace& known, double relative, double absolute);
  /// After deepest(): no place of the surface is deeper.
  double deepestAtMost() const { return atMost_; }

private:
  /// A part of a triangle.
  struct Piece
  {
    std::array<glm::dvec3, 3> corners;
    double max; ///< no place of it is deeper
    int slot;
    int hint;        ///< slot of an element of the other mesh that may be near
    int middle = -1; ///< index in middles_; -1 if that is not known

    glm::dvec3 centre() const { return (corners[0] + corners[1] + corners[2]) / 3.0; }
  };

  /// Finds what is closest to some of the enclosed points.
  /// @param known the first point of those before `begin` whose closest elements are known.
  void findClosest(std::size_t begin, std::size_t end, std::size_t known);
  /// Whether a triangle may be partly inside. Next to a hole it need not be cut for that.
  bool isMixed(int slot) const { return solid_.open() || enclosed_.isCut(slot); }
  /// The first corner of a triangle that is inside.
  int firstInside(int slot) const;
  void trySeeds(const std::vector<CutPlace>& crossings, DeepPlace& best) const;
  void tryPlace(const glm::dvec3& x, int slot, DeepPlace& best) const;
  /// Bounds the depths of a triangle by those of its corners that are inside.
  Piece wholeTriangle(int slot) const;
  void addPiece(const Piece& piece, double limit);
  /// Adds the four parts of a piece.
  /// @param max no place of them is deeper.
  void addParts(const Piece& piece, double max, int hint, double limit);
  /// Looks at the middle of a piece, and adds its four parts if they may be deeper.
  void refine(const Piece& piece, DeepPlace& best, double relative, double absolute);

  const MovingMesh& mesh_;
  const MovingMesh& other_;
  const SolidQuery& solid_;
  EnclosedPoints enclosed_;
  std::vector<ClosestElement> closest_;
  double atMost_ = 0.0;
  std::vector<Piece> pieces_;           ///< a heap, the largest bound first
  std::vector<ClosestElement> middles_; ///< what is closest to the middles of parts of pieces
};

} // namespace medial
