#include "axis/face_complex.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

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

} // namespace

FaceComplex::FaceComplex(const MedialAxis& axis)
  : faceCount_(static_cast<std::int64_t>(axis.quads.size() + axis.triangles.size()))
  , edgesOf_(faceCount_, { kNone, kNone, kNone, kNone })
  , gone_(faceCount_, 0)
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

/// Adds the edges from a point to higher ones.
void FaceComplex::addEdges(std::int64_t point, const Use* use, const Use* end)
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
      *std::find(edges.begin(), edges.end(), kNone) = static_cast<std::int64_t>(edges_.size()) - 1;
    }
  }
}

void FaceComplex::collapse()
{
  std::vector<std::size_t> pending;
  for (std::size_t edge = 0; edge < edges_.size(); ++edge)
  {
    pending.push_back(edge);
    while (!pending.empty())
    {
      const Left left = left_[pending.back()];
      pending.pop_back();
      if (left.count != 1 || left.outside > 0)
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

DisjointSets FaceComplex::patches() const
{
  DisjointSets patches(static_cast<std::size_t>(faceCount_));
  for (std::size_t edge = 0; edge < edges_.size(); ++edge)
  {
    if (left_[edge].count == 2 && left_[edge].outside == 0)
    {
      std::array<std::int64_t, 2> faces{};
      std::size_t found = 0;
      this->visitLeft(edge, [&](std::int64_t face) { faces[found++] = face; });
      patches.join(faces[0], faces[1]);
    }
  }
  return patches;
}

std::set<std::vector<std::int64_t>> FaceComplex::seams(DisjointSets& patches) const
{
  std::set<std::vector<std::int64_t>> seams;
  for (std::size_t edge = 0; edge < edges_.size(); ++edge)
  {
    if (left_[edge].count > 2 && left_[edge].outside == 0)
    {
      std::vector<std::int64_t> odd;
      this->visitLeft(edge,
        [&](std::int64_t face) { odd = symmetricDifference(odd, { patches.find(face) }); });
      seams.insert(std::move(odd));
    }
  }
  return seams;
}

std::int64_t rankOf(const std::set<std::vector<std::int64_t>>& sets)
{
  std::map<std::int64_t, std::vector<std::int64_t>> reduced; // by their first members
  for (std::vector<std::int64_t> set : sets)
  {
    while (!set.empty() && reduced.count(set.front()) > 0)
    {
      set = symmetricDifference(set, reduced[set.front()]);
    }
    if (!set.empty())
    {
      const std::int64_t first = set.front();
      reduced.emplace(first, std::move(set));
    }
  }
  return static_cast<std::int64_t>(reduced.size());
}

std::vector<std::int64_t> symmetricDifference(const std::vector<std::int64_t>& a,
  const std::vector<std::int64_t>& b)
{
  std::vector<std::int64_t> difference;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
    std::back_inserter(difference));
  return difference;
}

} // namespace medial
