#include "medial/cell_topology.h"

#include "base/disjoint_sets.h"
#include "medial/medial_axis.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <vector>

namespace medial
{
namespace
{

using Edge = std::array<std::int64_t, 2>; ///< ascending

/// Calls visit(a, b, face) for every edge of a face, and for every line with face -1; faces are
/// numbered quads first.
template <typename Visit>
void visitEdges(const MedialAxis& axis, const Visit& visit)
{
  std::int64_t face = 0;
  const auto visitFace = [&](const auto& corners)
  {
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::int64_t from = corners[i];
      const std::int64_t to = corners[(i + 1) % corners.size()];
      visit(std::min(from, to), std::max(from, to), face);
    }
    ++face;
  };
  std::for_each(axis.quads.begin(), axis.quads.end(), visitFace);
  std::for_each(axis.triangles.begin(), axis.triangles.end(), visitFace);
  for (const auto& [from, to] : axis.lines)
  {
    visit(std::min(from, to), std::max(from, to), std::int64_t{ -1 });
  }
}

/// Faces as lists of edges, and edges as lists of faces.
class FaceComplex
{
public:
  explicit FaceComplex(const MedialAxis& axis)
    : faceCount_(static_cast<std::int64_t>(axis.quads.size() + axis.triangles.size()))
    , edgesOf_(faceCount_, { kNone, kNone, kNone, kNone })
  {
    // Lists of the uses of edges at the lower of their points, and then in order.
    std::vector<std::size_t> starts(axis.points.size() + 1, 0);
    visitEdges(axis, [&](std::int64_t a, std::int64_t, std::int64_t) { ++starts[a + 1]; });
    std::partial_sum(starts.begin(), starts.end(), starts.begin());
    std::vector<Use> uses(starts.back());
    std::vector<std::size_t> next(starts.begin(), starts.end() - 1);
    visitEdges(axis,
      [&](std::int64_t a, std::int64_t b, std::int64_t face) {
        uses[next[a]++] = { b, face };
      });
    for (std::size_t point = 0; point + 1 < starts.size(); ++point)
    {
      std::sort(uses.begin() + starts[point], uses.begin() + starts[point + 1]);
      this->addEdges(static_cast<std::int64_t>(point), uses.data() + starts[point],
        uses.data() + starts[point + 1]);
    }
  }

  std::int64_t faceCount() const { return faceCount_; }
  const std::vector<Edge>& edges() const { return edges_; }

  /// Returns the rank of the second homology with coefficients modulo 2. Faces that end somewhere
  /// bound nothing and are removed. The rest are patches of a manifold: a cycle has all of a patch
  /// or nothing of it, and each seam of three or more adds a condition.
  std::int64_t cavities()
  {
    this->collapse();
    DisjointSets patches(static_cast<std::size_t>(faceCount_));
    for (std::size_t edge = 0; edge < edges_.size(); ++edge)
    {
      if (left_[edge].count == 2)
      {
        // The faces that are left, a and b, have a xor b as their sum.
        const std::int64_t face = this->firstLeft(edge);
        patches.join(face, left_[edge].sum ^ face);
      }
    }
    std::int64_t count = 0;
    for (std::int64_t face = 0; face < faceCount_; ++face)
    {
      count += gone_[face] == 0 && patches.find(face) == face ? 1 : 0;
    }
    return count - this->rankOfSeams(patches);
  }

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
  };

  /// Adds the edges from a point to higher ones.
  void addEdges(std::int64_t point, const Use* use, const Use* end)
  {
    for (std::int64_t last = kNone; use != end; ++use)
    {
      if (use->end != last)
      {
        last = use->end;
        edges_.push_back({ point, last });
        left_.emplace_back();
        firstFace_.push_back(faces_.size());
      }
      if (use->face >= 0)
      {
        faces_.push_back(use->face);
        ++left_.back().count;
        left_.back().sum ^= use->face;
        auto& edges = edgesOf_[use->face];
        *std::find(edges.begin(), edges.end(), kNone) =
          static_cast<std::int64_t>(edges_.size()) - 1;
      }
    }
  }

  /// Calls visit(face) for the faces at an edge that are left.
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

  std::int64_t firstLeft(std::size_t edge) const
  {
    return *std::find_if(faces_.begin() + firstFace_[edge], faces_.end(),
      [&](std::int64_t face) { return gone_[face] == 0; });
  }

  /// Removes faces with an edge of their own until there are none.
  void collapse()
  {
    gone_.assign(faceCount_, 0);
    std::vector<std::size_t> pending;
    for (std::size_t edge = 0; edge < edges_.size(); ++edge)
    {
      pending.push_back(edge);
      while (!pending.empty())
      {
        const Left left = left_[pending.back()];
        pending.pop_back();
        if (left.count != 1)
        {
          continue;
        }
        gone_[left.sum] = 1;
        for (const std::int64_t other : edgesOf_[left.sum])
        {
          if (other != kNone)
          {
            --left_[other].count;
            left_[other].sum ^= left.sum;
            pending.push_back(other);
          }
        }
      }
    }
  }

  /// Returns the patches at an edge that count an odd number of times, ascending.
  std::vector<std::int64_t> oddPatches(std::size_t edge, DisjointSets& patches) const
  {
    std::vector<std::int64_t> odd;
    this->visitLeft(edge, [&](std::int64_t face) { odd = sumOf(odd, { patches.find(face) }); });
    return odd;
  }

  /// Returns what is in one of two sets, but not in both.
  static std::vector<std::int64_t> sumOf(const std::vector<std::int64_t>& a,
    const std::vector<std::int64_t>& b)
  {
    std::vector<std::int64_t> sum;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
    return sum;
  }

  std::int64_t rankOfSeams(DisjointSets& patches) const
  {
    std::set<std::vector<std::int64_t>> conditions;
    for (std::size_t edge = 0; edge < edges_.size(); ++edge)
    {
      if (left_[edge].count > 2)
      {
        conditions.insert(this->oddPatches(edge, patches));
      }
    }
    std::map<std::int64_t, std::vector<std::int64_t>> reduced; // by their lowest patch
    for (std::vector<std::int64_t> condition : conditions)
    {
      while (!condition.empty() && reduced.count(condition.front()) > 0)
      {
        condition = sumOf(condition, reduced[condition.front()]);
      }
      if (!condition.empty())
      {
        const std::int64_t lowest = condition.front();
        reduced.emplace(lowest, std::move(condition));
      }
    }
    return static_cast<std::int64_t>(reduced.size());
  }

  std::int64_t faceCount_;
  std::vector<std::array<std::int64_t, 4>> edgesOf_; ///< each face; kNone at the end of triangles
  std::vector<Edge> edges_;
  std::vector<Left> left_;             ///< at each edge
  std::vector<std::size_t> firstFace_; ///< of each edge in `faces_`
  std::vector<std::int64_t> faces_;
  std::vector<char> gone_;
};

/// Marks the points that cells use.
std::vector<char> usedPoints(const MedialAxis& axis, const std::vector<Edge>& edges)
{
  std::vector<char> used(axis.points.size(), 0);
  for (const Edge& edge : edges)
  {
    used[edge[0]] = 1;
    used[edge[1]] = 1;
  }
  for (const std::int64_t vertex : axis.vertices)
  {
    used[vertex] = 1;
  }
  return used;
}

} // namespace

CellTopology topologyOf(const MedialAxis& axis)
{
  FaceComplex complex(axis);
  const std::vector<char> used = usedPoints(axis, complex.edges());
  DisjointSets pieces(axis.points.size());
  for (const Edge& edge : complex.edges())
  {
    pieces.join(edge[0], edge[1]);
  }
  CellTopology topology;
  std::int64_t points = 0;
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    const auto point = static_cast<std::int64_t>(p);
    points += used[p];
    topology.components += used[p] != 0 && pieces.find(point) == point ? 1 : 0;
  }
  topology.eulerCharacteristic =
    points - static_cast<std::int64_t>(complex.edges().size()) + complex.faceCount();
  topology.cavities = complex.cavities();
  topology.genus = topology.components + topology.cavities - topology.eulerCharacteristic;
  return topology;
}

} // namespace medial
