#pragma once

#include "medial/grid.h"
#include "medial/ranks.h"
#include "ranks/collective.h"

#include <array>
#include <cstddef>
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
  /// Edges of the whole surface.
  struct EdgeCounts
  {
    std::int64_t boundary;
    std::int64_t nonManifold; ///< with three triangles or more
    std::int64_t misoriented; ///< as MeshConnectivity
  };

  /// Every rank calls it.
  /// @throws Error InvalidInput, on every rank, for a surface without triangles, and for segments
  ///   or points of no triangle.
  DistributedSurface(Communicator& communicator, const SurfacePiece& piece);

  int faceCount() const { return static_cast<int>(faceOffsets_.total()); }
  int edgeCount() const { return static_cast<int>(edgeOffsets_.total()); }
  int pointCount() const { return static_cast<int>(pointOffsets_.total()); }
  const EdgeCounts& edgeCounts() const { return edgeCounts_; }
  /// As of the whole mesh.
  const Bounds& bounds() const { return bounds_; }
  double signedVolume() const { return signedVolume_; }

  /// The triangles of this rank's share: all numbers from the first to the last.
  const std::vector<FaceRecord>& faces() const { return faces_; }
  /// Drops the triangles of this rank's share; numbers and figures of the whole stay.
  void dropFaces();
  /// Where a triangle of this rank's share comes from.
  struct Origin
  {
    int rank;
    int triangle; ///< of its piece
  };
  /// In the order of faces().
  const std::vector<Origin>& origins() const { return origins_; }
  /// The numbers of the points of this rank's piece.
  const std::vector<int>& pointsOfPiece() const { return pointsOfPiece_; }
  /// Returns the numbers of the edges of the triangles of this rank's piece. Every rank calls it.
  /// @param triangles how many these are.
  std::vector<std::array<int, 3>> edgesOfPiece(Communicator& communicator,
    std::size_t triangles) const;
  /// Returns the rank whose share has a triangle.
  int homeOfFace(int face) const { return faceOffsets_.home(face); }
  /// Returns where faces() has a triangle of this rank.
  std::size_t indexOf(int face) const { return face - faces_.front().face; }

  /// Returns the rank whose share has a point; points come in runs.
  int homeOfPoint(int point) const
  {
    return homeOf(point, this->pointCount(), static_cast<int>(pointOffsets_.first.size()) - 1);
  }

  /// Returns some triangles of any ranks. Every rank calls it.
  /// @param faces numbers, ascending.
  std::vector<FaceRecord> fetch(Communicator& communicator, const std::vector<int>& faces) const;

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

  void collectFaces(Communicator& communicator, const SurfacePiece& piece);
  /// Numbers and counts edges.
  void connect(Communicator& communicator);
  void countEdges(Communicator& communicator, const std::vector<Side>& sides);
  void requireNothingLoose(Communicator& communicator, const SurfacePiece& piece) const;
  /// Numbers the edges whose first sides are named, and returns their numbers.
  std::vector<int> numberEdges(Communicator& communicator,
    const std::vector<std::array<int, 2>>& firstSides);
  double sumVolume(Communicator& communicator) const;

  RankOffsets pointOffsets_;
  RankOffsets faceOffsets_;
  RankOffsets edgeOffsets_;
  EdgeCounts edgeCounts_{};
  Bounds bounds_;
  double signedVolume_ = 0.0;
  std::vector<int> pointsOfPiece_;
  std::vector<FaceRecord> faces_;
  std::vector<Origin> origins_;
};

} // namespace medial
