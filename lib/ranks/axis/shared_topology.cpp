#include "axis/face_complex.h"
#include "base/disjoint_sets.h"
#include "medial/ranks.h"
#include "ranks/collective.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace medial
{
namespace
{

using Edge = FaceComplex::Edge;
using Link = std::array<std::int64_t, 2>; ///< two labels, ascending

/// A point of a piece.
struct PointUse
{
  std::int64_t point;
  std::int64_t label; ///< of its component within the piece
};

/// A face at an edge that several pieces have.
struct FaceUse
{
  std::int64_t edge; ///< number of the edge in the list that its rank sent
  std::int64_t patch;
};

/// Items that each rank sent, in the order of what they are about: calls visit(first, end) for the
/// pairs of a rank and an index whose items are equal.
template <typename Item, typename KeyOf, typename Visit>
void visitEqual(const RankLists<Item>& lists, const KeyOf& keyOf, const Visit& visit)
{
  std::vector<std::pair<std::size_t, std::size_t>> order;
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (std::size_t i = 0; i < lists[rank].size(); ++i)
    {
      order.emplace_back(rank, i);
    }
  }
  const auto key = [&](const auto& at) { return keyOf(lists[at.first][at.second]); };
  std::sort(order.begin(), order.end(),
    [&](const auto& a, const auto& b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  for (auto first = order.begin(); first != order.end();)
  {
    const auto end =
      std::find_if(first, order.end(), [&](const auto& at) { return key(at) != key(*first); });
    visit(first, end);
    first = end;
  }
}

std::vector<std::int64_t> sumsOf(Communicator& communicator,
  const std::vector<std::int64_t>& counts)
{
  return combined(communicator, counts, std::plus<>());
}

/// The cells of an axis in pieces, as one rank sees them: which points and edges others have, too.
class SharedCells
{
public:
  /// Every rank calls it, and each of the following.
  SharedCells(Communicator& communicator, const AxisPiece& piece)
    : communicator_(communicator)
    , piece_(piece)
    , complex_(piece.axis)
  {
    this->sharePoints();
    this->shareEdges();
  }

  CellTopology topology()
  {
    this->collapse();
    const std::int64_t cavities = this->cavities();
    const std::vector<std::int64_t> counts =
      sumsOf(communicator_, { points_, edges_, complex_.faceCount() });
    CellTopology topology;
    topology.components = components_;
    topology.eulerCharacteristic = counts[0] - counts[1] + counts[2];
    topology.cavities = cavities;
    topology.genus = components_ + cavities - topology.eulerCharacteristic;
    return topology;
  }

private:
  int homeOfPoint(std::int64_t point) const
  {
    return homeOf(point, piece_.points, communicator_.size());
  }

  /// Returns how many sets `count` labels of this rank and those of others make once some of them
  /// are joined.
  /// @param links that this rank has found, each once.
  std::int64_t joined(std::int64_t count, const std::set<Link>& links)
  {
    const RankOffsets labels(communicator_, count);
    RankLists<Link> lists = listsFor<Link>(communicator_);
    lists.front().assign(links.begin(), links.end());
    lists = exchanged(communicator_, std::move(lists));
    if (communicator_.rank() == 0)
    {
      sets_.reset(static_cast<std::size_t>(labels.total()));
    }
    std::int64_t sets = labels.total();
    for (const std::vector<Link>& list : lists)
    {
      for (const auto& [a, b] : list)
      {
        sets -= sets_.join(a, b) ? 1 : 0;
      }
    }
    return gathered(communicator_, sets).front();
  }

  /// Counts points and components, and finds the points that others have.
  void sharePoints()
  {
    DisjointSets pieces(piece_.axis.points.size());
    for (const auto& [a, b] : complex_.edges())
    {
      pieces.join(a, b);
    }
    std::vector<std::int64_t> labelOf(piece_.axis.points.size());
    std::int64_t count = 0;
    for (std::size_t p = 0; p < labelOf.size(); ++p)
    {
      const std::int64_t root = pieces.find(static_cast<std::int64_t>(p));
      labelOf[p] = static_cast<std::size_t>(root) == p ? count++ : labelOf[root];
    }
    const std::int64_t first = RankOffsets(communicator_, count).first[communicator_.rank()];
    RankLists<PointUse> uses = listsFor<PointUse>(communicator_);
    for (std::size_t p = 0; p < labelOf.size(); ++p)
    {
      const std::int64_t point = piece_.globalPointIds[p];
      uses[this->homeOfPoint(point)].push_back({ point, first + labelOf[p] });
    }
    uses = exchanged(communicator_, std::move(uses));
    RankLists<char> isShared(uses.size());
    std::transform(uses.begin(), uses.end(), isShared.begin(),
      [](const std::vector<PointUse>& list) { return std::vector<char>(list.size(), 0); });
    std::set<Link> links;
    visitEqual(
      uses, [](const PointUse& use) { return use.point; },
      [&](auto at, auto end)
      {
        ++points_;
        const std::int64_t label = uses[at->first][at->second].label;
        const bool shared = end - at > 1;
        for (; at != end; ++at)
        {
          const std::int64_t other = uses[at->first][at->second].label;
          isShared[at->first][at->second] = shared ? 1 : 0;
          if (other != label)
          {
            links.insert({ std::min(label, other), std::max(label, other) });
          }
        }
      });
    components_ = this->joined(count, links);
    isShared = exchanged(communicator_, std::move(isShared));
    std::vector<std::size_t> next(isShared.size(), 0);
    for (const std::int64_t point : piece_.globalPointIds)
    {
      const int home = this->homeOfPoint(point);
      isShared_.push_back(isShared[home][next[home]++]);
    }
  }

  /// Counts edges, and finds those that others may have: between points that they have.
  void shareEdges()
  {
    sent_.resize(static_cast<std::size_t>(communicator_.size()));
    asked_.resize(sent_.size());
    const std::vector<Edge>& edges = complex_.edges();
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const auto& [a, b] = edges[i];
      if (isShared_[a] == 0 || isShared_[b] == 0)
      {
        ++edges_;
        continue;
      }
      const auto [low, high] = std::minmax(piece_.globalPointIds[a], piece_.globalPointIds[b]);
      sent_[this->homeOfPoint(low)].push_back(i);
      asked_[this->homeOfPoint(low)].push_back({ low, high });
    }
    asked_ = exchanged(communicator_, std::move(asked_));
    visitEqual(
      asked_, [](const Edge& edge) { return edge; }, [&](auto, auto) { ++edges_; });
  }

  /// Removes faces with an edge of their own, on all ranks, until there are none.
  void collapse()
  {
    do
    {
      this->learnOutside();
      complex_.collapse();
    } while (this->changed());
  }

  /// Learns how many faces others have at shared edges.
  void learnOutside()
  {
    RankLists<std::int64_t> counts(sent_.size());
    for (std::size_t home = 0; home < sent_.size(); ++home)
    {
      std::transform(sent_[home].begin(), sent_[home].end(), std::back_inserter(counts[home]),
        [&](std::size_t edge) { return complex_.leftAt(edge); });
    }
    own_ = counts;
    counts = exchanged(communicator_, std::move(counts));
    visitEqual(
      asked_, [](const Edge& edge) { return edge; },
      [&](auto first, auto end)
      {
        std::int64_t all = 0;
        std::for_each(first, end, [&](const auto& at) { all += counts[at.first][at.second]; });
        std::for_each(first, end, [&](const auto& at) { counts[at.first][at.second] = all; });
      });
    counts = exchanged(communicator_, std::move(counts));
    for (std::size_t home = 0; home < sent_.size(); ++home)
    {
      for (std::size_t i = 0; i < sent_[home].size(); ++i)
      {
        complex_.setOutside(sent_[home][i], counts[home][i] - own_[home][i]);
      }
    }
  }

  /// Returns whether any rank has removed a face at a shared edge since the last time.
  bool changed()
  {
    bool here = false;
    for (std::size_t home = 0; home < sent_.size(); ++home)
    {
      for (std::size_t i = 0; i < sent_[home].size(); ++i)
      {
        here = here || complex_.leftAt(sent_[home][i]) != own_[home][i];
      }
    }
    return maximum(communicator_, here ? 1 : 0) != 0;
  }

  /// As one process counts them: independent conditions less than patches.
  std::int64_t cavities()
  {
    DisjointSets faces = complex_.patches();
    std::vector<std::int64_t> labelOf(static_cast<std::size_t>(complex_.faceCount()), -1);
    std::int64_t count = 0;
    for (std::int64_t face = 0; face < complex_.faceCount(); ++face)
    {
      if (complex_.isLeft(face))
      {
        const std::int64_t root = faces.find(face);
        labelOf[face] = root == face ? count++ : labelOf[root];
      }
    }
    const std::int64_t first = RankOffsets(communicator_, count).first[communicator_.rank()];
    std::set<Link> links;
    std::set<std::vector<std::int64_t>> seams;
    for (const std::vector<std::int64_t>& seam : complex_.seams(faces))
    {
      std::vector<std::int64_t> labels;
      std::transform(seam.begin(), seam.end(), std::back_inserter(labels),
        [&](std::int64_t face) { return first + labelOf[face]; });
      seams.insert(std::move(labels));
    }
    this->matchFaces(first, labelOf, links, seams);
    const std::int64_t patches = this->joined(count, links);
    const std::vector<std::vector<std::int64_t>> all = this->atFirst(seams);
    std::set<std::vector<std::int64_t>> conditions;
    for (const std::vector<std::int64_t>& labels : all)
    {
      std::vector<std::int64_t> odd;
      for (const std::int64_t label : labels)
      {
        odd = symmetricDifference(odd, { sets_.find(label) });
      }
      conditions.insert(std::move(odd));
    }
    return gathered(communicator_, patches - rankOf(conditions)).front();
  }

  /// Finds the patches that meet at edges of several ranks.
  /// @param first label of this rank.
  void matchFaces(std::int64_t first, const std::vector<std::int64_t>& labelOf,
    std::set<Link>& links, std::set<std::vector<std::int64_t>>& seams)
  {
    RankLists<FaceUse> uses = listsFor<FaceUse>(communicator_);
    for (std::size_t home = 0; home < sent_.size(); ++home)
    {
      for (std::size_t i = 0; i < sent_[home].size(); ++i)
      {
        complex_.visitLeft(sent_[home][i],
          [&](std::int64_t face) {
            uses[home].push_back({ static_cast<std::int64_t>(i), first + labelOf[face] });
          });
      }
    }
    uses = exchanged(communicator_, std::move(uses));
    RankLists<std::vector<std::int64_t>> patches(asked_.size());
    for (std::size_t rank = 0; rank < asked_.size(); ++rank)
    {
      patches[rank].resize(asked_[rank].size());
      for (const FaceUse& use : uses[rank])
      {
        patches[rank][use.edge].push_back(use.patch);
      }
    }
    visitEqual(
      asked_, [](const Edge& edge) { return edge; },
      [&](auto at, auto end)
      {
        std::vector<std::int64_t> labels;
        for (; at != end; ++at)
        {
          const std::vector<std::int64_t>& list = patches[at->first][at->second];
          labels.insert(labels.end(), list.begin(), list.end());
        }
        std::sort(labels.begin(), labels.end());
        if (labels.size() == 2)
        {
          links.insert({ labels[0], labels[1] });
        }
        else if (labels.size() > 2)
        {
          seams.insert(std::move(labels));
        }
      });
  }

  /// Returns, on the first rank, the lists of all ranks.
  std::vector<std::vector<std::int64_t>> atFirst(const std::set<std::vector<std::int64_t>>& own)
  {
    RankLists<std::int64_t> lists = listsFor<std::int64_t>(communicator_);
    for (const std::vector<std::int64_t>& list : own)
    {
      lists.front().push_back(static_cast<std::int64_t>(list.size()));
      lists.front().insert(lists.front().end(), list.begin(), list.end());
    }
    std::vector<std::vector<std::int64_t>> all;
    for (const std::vector<std::int64_t>& values : exchanged(communicator_, lists))
    {
      for (auto at = values.begin(); at != values.end();)
      {
        const auto first = at + 1;
        at = first + *at;
        all.emplace_back(first, at);
      }
    }
    return all;
  }

  Communicator& communicator_;
  const AxisPiece& piece_;
  FaceComplex complex_;
  std::vector<char> isShared_;                 ///< points that others have
  std::vector<std::vector<std::size_t>> sent_; ///< edges that others may have, by who counts them
  RankLists<Edge> asked_;                      ///< those that this rank counts, by who sent them
  RankLists<std::int64_t> own_;                ///< faces at the edges of `sent_`
  std::int64_t points_ = 0;                    ///< that this rank counts
  std::int64_t edges_ = 0;
  std::int64_t components_ = 0; ///< of all
  DisjointSets sets_;           ///< of labels, on the first rank
};

} // namespace

CellTopology topologyOf(Communicator& communicator, const AxisPiece& piece)
{
  CellTopology topology;
  agree(communicator, [&] { topology = SharedCells(communicator, piece).topology(); });
  return topology;
}

} // namespace medial
