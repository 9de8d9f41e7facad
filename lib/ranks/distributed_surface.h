#pragma once

#include "medial/grid.h"
#include "medial/ranks.h"
#include "ranks/collective.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// A triangle with the numbers that its parts have in the whole surface: those that one process
/// gives them.
struct FaceRecord
{
  std::int64_t cell;
  int face;
  std::array<int, 3> corners; ///< points
  std::array<int, 3> edges;   ///< from each corner to the next
  std::array<Point3, 3> points;
};

/// A surface whose triangles are shared out among ranks, in their order. Points and edges that
/// triangles of several ranks share are matched by the bits of positions.
class DistributedSurface
{
public:
  /// Every rank calls it.
  /// @throws Error InvalidInput, on every rank, for a surface without triangles or that is not
  ///   manifold, and for segments or points of no triangle.
  DistributedSurface(Communicator& communicator, const SurfacePiece& piece);

  int faceCount() const { return static_cast<int>(faceOffsets_.total()); }
  int edgeCount() const { return static_cast<int>(edgeOffsets_.total()); }
  int pointCount() const { return static_cast<int>(pointOffsets_.total()); }
  std::int64_t boundaryEdges() const { return boundaryEdges_; }
  /// As of the whole mesh.
  const Bounds& bounds() const { return bounds_; }
  double signedVolume() const { return signedVolume_; }

  /// The triangles of this rank's share, ascending.
  const std::vector<FaceRecord>& faces() const { return faces_; }

  /// Returns all triangles around some points. Every rank calls it.
  /// @param points numbers, any.
  std::vector<FaceRecord> around(Communicator& communicator, const std::vector<int>& points) const;

private:
  /// Two points that a side of a triangle joins.
  struct Side
  {
    int low;
    int high;
    int face;
    int corner;
    int forward; ///< 1 if it runs from the lower point to the higher, else -1

    bool joins(const Side& other) const { return low == other.low && high == other.high; }
  };

  std::vector<int> numberPoints(Communicator& communicator, const SurfacePiece& piece);
  void collectFaces(Communicator& communicator, const SurfacePiece& piece,
    const std::vector<int>& numbers);
  void connect(Communicator& communicator, const SurfacePiece& piece,
    const std::vector<int>& numbers);
  /// Numbers the edges whose first sides are named, and returns their numbers.
  RankLists<int> numberEdges(Communicator& communicator,
    const RankLists<std::array<int, 2>>& firstSides);
  void collectRings(Communicator& communicator);
  int pointHome(int point) const
  {
    return homeOf(point, this->pointCount(), static_cast<int>(pointOffsets_.first.size()) - 1);
  }
  /// Number of fans of the triangles around one of this rank's points, and whether one is closed.
  bool isManifoldPoint(int point) const;
  double sumVolume(Communicator& communicator) const;

  RankOffsets pointOffsets_;
  RankOffsets faceOffsets_;
  RankOffsets edgeOffsets_;
  std::int64_t boundaryEdges_ = 0;
  Bounds bounds_;
  double signedVolume_ = 0.0;
  std::vector<FaceRecord> faces_;
  std::vector<FaceRecord> rings_;                ///< triangles around this rank's points
  std::vector<std::pair<int, int>> ringOfPoint_; ///< points, and where their triangles are; sorted
};

} // namespace medial
