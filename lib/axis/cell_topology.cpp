#include "medial/cell_topology.h"

#include "base/disjoint_sets.h"
#include "medial/medial_axis.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace medial
{
namespace
{

using Edge = std::array<std::int64_t, 2>; ///< ascending

/// An edge of a face.
struct EdgeUse
{
  Edge edge;
  std::int64_t face;
};

/// Faces as lists of edges, and edges as lists of faces.
class FaceComplex
{
public:
  explicit FaceComplex(const MedialAxis& axis)
  {
    for (const auto& quad : axis.quads)
    {
      this->addFace(quad.data(), 4);
    }
    for (const auto& triangle : axis.triangles)
    {
      this->addFace(triangle.data(), 3);
    }
    for (const auto& line : axis.lines)
    {
      uses_.push_back({ ordered(line[0], line[1]), -1 });
    }
    std::sort(uses_.begin(), uses_.end(),
      [](const EdgeUse& a, const EdgeUse& b)
      { return a.edge != b.edge ? a.edge < b.edge : a.face < b.face; });
    facesEdges_.resize(faceCount_);
    for (std::size_t i = 0; i < uses_.size(); ++i)
    {
      if (i == 0 || uses_[i].edge != uses_[i - 1].edge)
      {
        edges_.push_back(uses_[i].edge);
        edgeFaces_.emplace_back();
      }
      if (uses_[i].face >= 0)
      {
        edgeFaces_.back().push_back(uses_[i].face);
        facesEdges_[uses_[i].face].push_back(edges_.size() - 1);
      }
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
    for (const auto& faces : edgeFaces_)
    {
      if (faces.size() == 2)
      {
        patches.join(faces[0], faces[1]);
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
  static Edge ordered(std::int64_t a, std::int64_t b) { return { std::min(a, b), std::max(a, b) }; }

  void addFace(const std::int64_t* corners, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      uses_.push_back({ ordered(corners[i], corners[(i + 1) % count]), faceCount_ });
    }
    ++faceCount_;
  }

  /// Removes faces with an edge of their own until there are none.
  void collapse()
  {
    gone_.assign(faceCount_, 0);
    std::vector<std::size_t> pending(edges_.size());
    for (std::size_t edge = 0; edge < pending.size(); ++edge)
    {
      pending[edge] = edge;
    }
    while (!pending.empty())
    {
      const std::size_t edge = pending.back();
      pending.pop_back();
      if (edgeFaces_[edge].size() != 1)
      {
        continue;
      }
      const std::int64_t face = edgeFaces_[edge].front();
      gone_[face] = 1;
      for (const std::size_t other : facesEdges_[face])
      {
        auto& faces = edgeFaces_[other];
        faces.erase(std::find(faces.begin(), faces.end(), face));
        pending.push_back(other);
      }
    }
  }

  std::int64_t rankOfSeams(DisjointSets& patches) const
  {
    std::set<std::set<std::int64_t>> conditions;
    for (const auto& faces : edgeFaces_)
    {
      std::set<std::int64_t> odd;
      for (const std::int64_t face : faces)
      {
        toggle(patches.find(face), odd);
      }
      conditions.insert(odd);
    }
    std::map<std::int64_t, std::set<std::int64_t>> reduced; // by their lowest patch
    for (std::set<std::int64_t> condition : conditions)
    {
      while (!condition.empty() && reduced.count(*condition.begin()) > 0)
      {
        for (const std::int64_t patch : std::set<std::int64_t>(reduced[*condition.begin()]))
        {
          toggle(patch, condition);
        }
      }
      if (!condition.empty())
      {
        const std::int64_t lowest = *condition.begin();
        reduced.emplace(lowest, std::move(condition));
      }
    }
    return static_cast<std::int64_t>(reduced.size());
  }

  static void toggle(std::int64_t patch, std::set<std::int64_t>& set)
  {
    if (!set.insert(patch).second)
    {
      set.erase(patch);
    }
  }

  std::int64_t faceCount_ = 0;
  std::vector<EdgeUse> uses_;
  std::vector<Edge> edges_;
  std::vector<std::vector<std::int64_t>> edgeFaces_;
  std::vector<std::vector<std::size_t>> facesEdges_;
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
