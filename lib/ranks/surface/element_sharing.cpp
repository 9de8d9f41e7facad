#include "ranks/surface/element_sharing.h"

#include "base/longest_axis.h"
#include "culling/site_group.h"
#include "ranks/selected_keys.h"
#include "sites/bounding_ball.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

namespace medial
{
namespace
{

std::vector<SharedElement> elementsOf(const DistributedSurface& surface,
  const LocalCoordinates& frame)
{
  std::vector<SharedElement> elements;
  for (const FaceRecord& face : surface.faces())
  {
    const glm::vec4 ball = ballAround({ frame.toLocal(face.points[0]),
      frame.toLocal(face.points[1]), frame.toLocal(face.points[2]) });
    elements.push_back({ { glm::vec3(ball), face.face }, face.corners, ball.w, 0, 0 });
  }
  return elements;
}

/// Sets the size classes, and returns how many elements each has.
std::map<int, std::int64_t> classify(Communicator& communicator, int count,
  std::vector<SharedElement>& elements)
{
  std::vector<ListedKey> radii;
  radii.reserve(elements.size());
  for (const SharedElement& element : elements)
  {
    radii.push_back({ static_cast<std::uint64_t>(ascending(element.radius)) << 32, 0 });
  }
  const std::uint64_t median = keysAt(communicator, radii, { count / 2 }).front();
  const SizeClasses sizes(valueOf(static_cast<std::uint32_t>(median >> 32)));
  int largest = 0;
  for (SharedElement& element : elements)
  {
    element.sizeClass = sizes.of(element.radius);
    largest = std::max(largest, element.sizeClass);
  }
  std::vector<std::int64_t> counts(maximum(communicator, largest) + 1, 0);
  for (const SharedElement& element : elements)
  {
    ++counts[element.sizeClass];
  }
  counts = combined(communicator, counts, std::plus<>());
  std::map<int, std::int64_t> classes;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    if (counts[i] > 0)
    {
      classes[static_cast<int>(i)] = counts[i];
    }
  }
  return classes;
}

/// As large as leaves every rank several blocks.
int blockSizeFor(std::int64_t count, int ranks)
{
  constexpr std::int64_t kPerRank = 8;
  int size = SiteGroup::kSize;
  while (count / (size * kLanes) >= kPerRank * ranks)
  {
    size *= kLanes;
  }
  return size;
}

/// A run of elements of the order.
struct RunOfElements
{
  int tree; ///< its index
  int first;
  int count;
};

/// Halves runs of more elements than a block has, until there are none.
class Halving
{
public:
  Halving(Communicator& communicator, const std::vector<BlockedTree>& trees,
    std::vector<SharedElement>& elements)
    : communicator_(communicator)
    , trees_(trees)
    , elements_(elements)
  {
    std::map<int, int> treeOf;
    for (std::size_t i = 0; i < trees.size(); ++i)
    {
      treeOf[trees[i].sizeClass] = static_cast<int>(i);
      runs_.push_back({ static_cast<int>(i), 0, trees[i].count });
    }
    for (const SharedElement& element : elements)
    {
      runOf_.push_back(treeOf[element.sizeClass]);
    }
    while (this->halve())
    {
    }
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      elements[i].first = runs_[runOf_[i]].first;
    }
  }

private:
  bool isLong(const RunOfElements& run) const { return run.count > trees_[run.tree].blockSize; }

  /// The axes along which the long runs are halved.
  std::vector<int> axes(const std::vector<int>& listOf, std::size_t lists) const
  {
    constexpr float kFar = std::numeric_limits<float>::max();
    std::vector<std::array<float, 6>> ends(lists, { kFar, kFar, kFar, kFar, kFar, kFar });
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
      const int list = listOf[runOf_[i]];
      for (int axis = 0; list >= 0 && axis < 3; ++axis)
      {
        const float value = elements_[i].place.centre[axis];
        ends[list][axis] = std::min(ends[list][axis], value);
        ends[list][3 + axis] = std::min(ends[list][3 + axis], -value);
      }
    }
    ends = combined(communicator_, ends,
      [](std::array<float, 6> a, const std::array<float, 6>& b)
      {
        for (int i = 0; i < 6; ++i)
        {
          a[i] = std::min(a[i], b[i]);
        }
        return a;
      });
    std::vector<int> result;
    for (const auto& end : ends)
    {
      result.push_back(longestAxis(
        glm::dvec3(glm::vec3(-end[3], -end[4], -end[5]) - glm::vec3(end[0], end[1], end[2]))));
    }
    return result;
  }

  bool halve()
  {
    std::vector<int> listOf(runs_.size(), -1); // of long runs
    std::vector<std::int64_t> halves;
    for (std::size_t run = 0; run < runs_.size(); ++run)
    {
      if (this->isLong(runs_[run]))
      {
        listOf[run] = static_cast<int>(halves.size());
        halves.push_back(firstHalf(runs_[run].count));
      }
    }
    if (halves.empty())
    {
      return false;
    }
    const std::vector<int> axes = this->axes(listOf, halves.size());
    std::vector<ListedKey> keys;
    std::vector<std::uint64_t> keyOf(elements_.size(), 0);
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
      const int list = listOf[runOf_[i]];
      if (list >= 0)
      {
        const ElementPlace& place = elements_[i].place;
        keyOf[i] = static_cast<std::uint64_t>(ascending(place.centre[axes[list]])) << 32 |
          static_cast<std::uint32_t>(place.site);
        keys.push_back({ keyOf[i], list });
      }
    }
    const std::vector<std::uint64_t> middles = keysAt(communicator_, keys, halves);
    std::vector<RunOfElements> shorter;
    std::vector<int> newRun;
    for (std::size_t run = 0; run < runs_.size(); ++run)
    {
      newRun.push_back(static_cast<int>(shorter.size()));
      const auto& [tree, first, count] = runs_[run];
      if (listOf[run] < 0)
      {
        shorter.push_back(runs_[run]);
        continue;
      }
      const auto half = static_cast<int>(halves[listOf[run]]);
      shorter.push_back({ tree, first, half });
      shorter.push_back({ tree, first + half, count - half });
    }
    for (std::size_t i = 0; i < elements_.size(); ++i)
    {
      const int list = listOf[runOf_[i]];
      runOf_[i] = newRun[runOf_[i]] + (list >= 0 && keyOf[i] >= middles[list] ? 1 : 0);
    }
    runs_ = std::move(shorter);
    return true;
  }

  Communicator& communicator_;
  const std::vector<BlockedTree>& trees_;
  std::vector<SharedElement>& elements_;
  std::vector<RunOfElements> runs_;
  std::vector<int> runOf_; ///< of each element
};

} // namespace

int SharedElements::home(int block, int ranks) const
{
  std::int64_t all = 0;
  std::int64_t before = 0; // elements of blocks before this one
  int first = 0;           // block of a tree
  for (const BlockedTree& tree : trees)
  {
    const int blocksBefore = std::clamp(block - first, 0, tree.blocks());
    before += std::min<std::int64_t>(tree.count, std::int64_t{ blocksBefore } * tree.blockSize);
    all += tree.count;
    first += tree.blocks();
  }
  return homeOf(before, all, ranks);
}

SharedElements shareElements(Communicator& communicator, const DistributedSurface& surface,
  const LocalCoordinates& frame)
{
  SharedElements shared;
  std::vector<SharedElement> elements = elementsOf(surface, frame);
  std::map<int, int> firstBlock; // by size class
  int blocks = 0;
  for (const auto& [size, count] : classify(communicator, surface.faceCount(), elements))
  {
    shared.trees.push_back(
      { size, static_cast<int>(count), blockSizeFor(count, communicator.size()) });
    firstBlock[size] = blocks;
    blocks += shared.trees.back().blocks();
  }
  const Halving halved(communicator, shared.trees, elements);
  RankLists<SharedElement> moved = listsFor<SharedElement>(communicator);
  std::map<int, int> blockSize;
  for (const BlockedTree& tree : shared.trees)
  {
    blockSize[tree.sizeClass] = tree.blockSize;
  }
  for (const SharedElement& element : elements)
  {
    const int block = firstBlock[element.sizeClass] + element.first / blockSize[element.sizeClass];
    moved[shared.home(block, communicator.size())].push_back(element);
  }
  shared.elements = flattened(exchanged(communicator, std::move(moved)));
  std::sort(shared.elements.begin(), shared.elements.end(),
    [](const SharedElement& a, const SharedElement& b)
    {
      return std::tie(a.sizeClass, a.first, a.place.site) <
        std::tie(b.sizeClass, b.first, b.place.site);
    });
  return shared;
}

} // namespace medial
