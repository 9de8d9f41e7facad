#pragma once

#include "base/disjoint_sets.h"
#include "medial/medial_axis.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace medial
{

/// The faces of an axis as lists of edges, and edges as lists of faces.
class FaceComplex
{
public:
  using Edge = std::array<std::int64_t, 2>; ///< points, ascending

  explicit FaceComplex(const MedialAxis& axis);

  std::int64_t faceCount() const { return faceCount_; }
  /// All edges, those of lines too.
  const std::vector<Edge>& edges() const { return edges_; }

  /// Sets how many faces an edge has that are not in this axis, where it is a piece of another.
  void setOutside(std::size_t edge, std::int64_t count) { left_[edge].outside = count; }
  /// Removes faces with an edge of their own until there are none.
  void collapse();

  ///@{
  /// Faces that are left.
  bool isLeft(std::int64_t face) const { return gone_[face] == 0; }
  std::int64_t leftAt(std::size_t edge) const { return left_[edge].count; }
  template <typename Visit>
  void visitLeft(std::size_t edge, const Visit& visit) const
  {
    const std::size_t end = edge + 1 < firstFace_.size() ? firstFace_[edge + 1] : faces_.size();
    for (std::size_t i = firstFace_[edge]; i < end; ++i)
    {
      if (gone_[faces_[i]] == 0)
      {
        visit(faces_[i]);
      }
    }
  }
  ///@}

  /// Joins the faces that are left through edges that only two of them have: patches of a manifold.
  DisjointSets patches() const;
  /// Returns the patches at each edge of three faces or more that are there an odd number of times,
  /// ascending. Edges with faces outside are left out.
  std::set<std::vector<std::int64_t>> seams(DisjointSets& patches) const;

private:
  static constexpr std::int64_t kNone = -1;

  /// Of an edge by a face.
  struct Use
  {
    std::int64_t end; ///< the higher point of the edge
    std::int64_t face;

    bool operator<(const Use& other) const
    {
      return end != other.end ? end < other.end : face < other.face;
    }
  };

  /// The faces at an edge that are not gone.
  struct Left
  {
    std::int64_t count = 0;
    std::int64_t sum = 0; ///< their numbers by exclusive or: that of the face where one is left
    std::int64_t outside = 0;
  };

  void addEdges(std::int64_t point, const Use* use, const Use* end);

  std::int64_t faceCount_;
  std::vector<std::array<std::int64_t, 4>> edgesOf_; ///< each face; kNone at the end of triangles
  std::vector<Edge> edges_;
  std::vector<Left> left_;             ///< at each edge
  std::vector<std::size_t> firstFace_; ///< of each edge in `faces_`
  std::vector<std::int64_t> faces_;
  std::vector<char> gone_;
};

/// Returns the rank of sets as vectors modulo 2.
std::int64_t rankOf(const std::set<std::vector<std::int64_t>>& sets);

/// Returns what is in one of two ascending lists, but not in both.
std::vector<std::int64_t> symmetricDifference(const std::vector<std::int64_t>& a,
  const std::vector<std::int64_t>& b);

} // namespace medial
