#include "skeleton/short_branches.h"

#include "skeleton/branch_balls.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{

/// A branch's end at a junction.
struct End
{
  std::size_t branch;
  int which; ///< 0 or 1
};

std::vector<std::vector<End>> endsAt(const GeometricNetwork& network)
{
  std::vector<std::vector<End>> ends(network.junctions.size());
  for (std::size_t b = 0; b < network.branches.size(); ++b)
  {
    for (const int which : { 0, 1 })
    {
      const int junction = network.branches[b].junctions[which];
      if (junction != NetworkBranch::kFree)
      {
        ends[junction].push_back({ b, which });
      }
    }
  }
  return ends;
}

/// Removes branches without points and junctions without ends.
/// @param marked indices of branches, which become the new ones.
void compact(GeometricNetwork& network, std::vector<char>& marked)
{
  const std::vector<std::vector<End>> ends = endsAt(network);
  std::vector<glm::dvec3> places;
  for (std::size_t j = 0; j < ends.size(); ++j)
  {
    for (const End& end : ends[j])
    {
      network.branches[end.branch].junctions[end.which] = static_cast<int>(places.size());
    }
    if (!ends[j].empty())
    {
      places.push_back(network.junctions[j]);
    }
  }
  network.junctions = std::move(places);
  std::size_t kept = 0;
  for (std::size_t b = 0; b < network.branches.size(); ++b)
  {
    if (!network.branches[b].curve.points.empty())
    {
      marked[kept] = marked[b];
      if (kept != b)
      {
        network.branches[kept] = std::move(network.branches[b]);
      }
      ++kept;
    }
  }
  network.branches.resize(kept);
  marked.resize(kept);
}

class Removal
{
public:
  Removal(GeometricNetwork& network, const SolidProbe& probe, double step, double minBranch)
    : network_(network)
    , probe_(probe)
    , step_(step)
    , minBranch_(minBranch)
    , balls_(probe)
    , ratios_(network.branches.size())
    , marked_(network.branches.size(), 0)
  {
  }

  ShortBranches run(const Checkpoint& checkpoint)
  {
    for (std::size_t b = 0; b < network_.branches.size(); ++b)
    {
      balls_.set(b, network_.branches[b].curve);
    }
    ShortBranches result;
    for (std::size_t b = this->worst(checkpoint); b < ratios_.size(); b = this->worst(checkpoint))
    {
      this->remove(b);
      result.removed = true;
    }
    if (result.removed)
    {
      compact(network_, marked_);
      for (std::size_t b = 0; b < marked_.size(); ++b)
      {
        if (marked_[b] != 0)
        {
          result.merged.push_back(b);
        }
      }
    }
    return result;
  }

private:
  /// Length and rise of a branch in the radii that they are compared with, whichever is less.
  struct Ratio
  {
    bool known = false;
    double value = 0.0;
    std::vector<std::size_t> neighbours; ///< branches that it depends on
  };

  Ratio ratioOf(const NetworkBranch& branch, std::size_t b) const
  {
    BranchRise rise = balls_.rise(b, minBranch_);
    const double length = arcLengths(branch.curve).back();
    const double ofLength = length / probe_.radius(network_.junctions[branch.junctions[0]]);
    const double ofRise = rise.size > 0.0 ? rise.length / std::max(rise.size, step_) : 0.0;
    return { true, std::min(ofLength, ofRise), std::move(rise.neighbours) };
  }

  /// Whether a branch may go: it has one free end.
  bool mayGo(std::size_t b) const
  {
    const auto [first, last] = network_.branches[b].junctions;
    return first != NetworkBranch::kFree && last == NetworkBranch::kFree;
  }

  /// Returns the branch that is too short by the most, or the number of branches.
  std::size_t worst(const Checkpoint& checkpoint)
  {
    tbb::parallel_for(std::size_t{ 0 }, ratios_.size(),
      [&](std::size_t b)
      {
        if (!ratios_[b].known && this->mayGo(b))
        {
          checkpoint();
          ratios_[b] = this->ratioOf(network_.branches[b], b);
        }
      });
    std::size_t result = ratios_.size();
    double least = minBranch_;
    for (std::size_t b = 0; b < ratios_.size(); ++b)
    {
      if (this->mayGo(b) && ratios_[b].value < least)
      {
        least = ratios_[b].value;
        result = b;
      }
    }
    return result;
  }

  void remove(std::size_t b)
  {
    const int junction = network_.branches[b].junctions[0];
    this->forget(b);
    network_.branches[b] = {};
    balls_.set(b, {});
    const std::vector<End> left = endsAt(network_)[junction];
    if (left.size() == 2)
    {
      this->merge(left[0], left[1]);
    }
  }

  /// Joins a branch to another one, which is empty then, through a junction where no other ends.
  /// Together they have the balls that each of them had, so that no other ratio changes.
  void merge(const End& first, const End& second)
  {
    NetworkBranch& branch = network_.branches[first.branch];
    marked_[first.branch] = 1;
    ratios_[first.branch] = {};
    if (first.branch == second.branch)
    {
      dropLast(branch.curve);
      branch.curve.closed = true;
      branch.junctions = { NetworkBranch::kFree, NetworkBranch::kFree };
      return;
    }
    NetworkBranch& other = network_.branches[second.branch];
    if (first.which == 0)
    {
      this->reverse(first.branch);
    }
    if (second.which == 1)
    {
      this->reverse(second.branch);
    }
    join(branch.curve, other.curve);
    balls_.join(first.branch, second.branch);
    branch.junctions[1] = other.junctions[1];
    other = {};
    ratios_[second.branch] = {};
    this->renameNeighbour(second.branch, first.branch);
    if (branch.junctions[0] == NetworkBranch::kFree && branch.junctions[1] != NetworkBranch::kFree)
    {
      this->reverse(first.branch);
    }
  }

  void reverse(std::size_t b)
  {
    NetworkBranch& branch = network_.branches[b];
    medial::reverse(branch.curve);
    std::swap(branch.junctions[0], branch.junctions[1]);
    balls_.reverse(b);
  }

  /// Forgets what depends on a branch.
  void forget(std::size_t b)
  {
    ratios_[b] = {};
    for (Ratio& ratio : ratios_)
    {
      if (std::binary_search(ratio.neighbours.begin(), ratio.neighbours.end(), b))
      {
        ratio = {};
      }
    }
  }

  void renameNeighbour(std::size_t before, std::size_t after)
  {
    for (Ratio& ratio : ratios_)
    {
      std::vector<std::size_t>& neighbours = ratio.neighbours;
      const auto at = std::lower_bound(neighbours.begin(), neighbours.end(), before);
      if (at != neighbours.end() && *at == before)
      {
        neighbours.erase(at);
        const auto place = std::lower_bound(neighbours.begin(), neighbours.end(), after);
        if (place == neighbours.end() || *place != after)
        {
          neighbours.insert(place, after);
        }
      }
    }
  }

  GeometricNetwork& network_;
  const SolidProbe& probe_;
  double step_;
  double minBranch_;
  BranchBalls balls_;
  std::vector<Ratio> ratios_;
  std::vector<char> marked_; ///< branches made of two
};

} // namespace

ShortBranches removeShortBranches(GeometricNetwork& network, const SolidProbe& probe, double step,
  double minBranch, const Checkpoint& checkpoint)
{
  return Removal(network, probe, step, minBranch).run(checkpoint);
}

} // namespace medial
