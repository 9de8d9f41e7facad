#pragma once

#include "proximity/moving_mesh.h"
#include "proximity/solid_query.h"

#include <vector>

namespace medial
{

/// Finds the points of a mesh that are inside another. Elements that do not intersect the other's
/// surface have all their points on one side of it, so one answer spreads over them.
class EnclosedPoints
{
public:
  /// A point inside, and the one from which the answer came; -1 if it was asked for itself.
  struct Enclosed
  {
    int point;
    int from; ///< index in points(), before this one
  };

  /// @param cut slots of the elements of the mesh that intersect the other, ascending.
  void find(const MovingMesh& mesh, const SolidQuery& solid, const Box& solidBox,
    const std::vector<int>& cut);

  /// In the order in which they were found: neighbours mostly follow each other.
  const std::vector<Enclosed>& points() const { return points_; }
  bool anyUndefined() const { return undefined_; }
  bool isCut(int slot) const { return cutAt_[slot] == frame_; }
  bool isInside(int point) const { return insideAt_[point] == frame_; }
  /// Index in points() of a point that is inside.
  int indexOf(int point) const { return indices_[point]; }

private:
  void begin(const MovingMesh& mesh, const std::vector<int>& cut);
  void ask(const MovingMesh& mesh, const SolidQuery& solid, const Box& solidBox, int point);
  void spread(const MovingMesh& mesh, int point, bool inside);

  // Marks are numbers of frames, so that nothing has to be cleared.
  int frame_ = 0;
  std::vector<int> cutAt_;       ///< per slot
  std::vector<int> seenAt_;      ///< per point
  std::vector<int> insideAt_;    ///< per point
  std::vector<int> rimAt_;       ///< per point: when an element of it was cut
  std::vector<int> indices_;     ///< per point
  std::vector<int> componentAt_; ///< per component: when an element of it was cut
  std::vector<Enclosed> points_;
  std::vector<int> pending_;
  bool spreads_ = true; ///< whether one answer is that of its neighbours
  bool undefined_ = false;
};

} // namespace medial
