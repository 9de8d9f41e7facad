#include "skeleton/short_branches.h"

#include <algorithm>
#include <utility>

namespace medial
{
namespace
{

/// Length and rise of a branch in the radii that they are compared with, whichever is less.
double ratioOf(const NetworkBranch& branch, double junctionRadius, const SolidProbe& probe)
{
  const double length = arcLengths(branch.curve).back();
  const double endRadius = probe.radius(branch.curve.points.back());
  const double rise = length + endRadius - junctionRadius;
  // An end on the surface has no radius.
  return std::min(length / junctionRadius, rise <= 0.0 ? 0.0 : rise / endRadius);
}

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

/// Joins a branch to another one, which is empty then, through a junction where no other ends.
void merge(GeometricNetwork& network, const End& first, const End& second)
{
  NetworkBranch& branch = network.branches[first.branch];
  if (first.branch == second.branch)
  {
    branch.curve.points.pop_back();
    branch.curve.closed = true;
    branch.junctions = { NetworkBranch::kFree, NetworkBranch::kFree };
    return;
  }
  NetworkBranch& other = network.branches[second.branch];
  if (first.which == 0)
  {
    reverse(branch.curve);
    std::swap(branch.junctions[0], branch.junctions[1]);
  }
  if (second.which == 1)
  {
    reverse(other.curve);
    std::swap(other.junctions[0], other.junctions[1]);
  }
  branch.curve.points.insert(branch.curve.points.end(), other.curve.points.begin() + 1,
    other.curve.points.end());
  branch.junctions[1] = other.junctions[1];
  other = {};
  if (branch.junctions[0] == NetworkBranch::kFree && branch.junctions[1] != NetworkBranch::kFree)
  {
    reverse(branch.curve);
    std::swap(branch.junctions[0], branch.junctions[1]);
  }
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

} // namespace

ShortBranches removeShortBranches(GeometricNetwork& network, const SolidProbe& probe,
  double minBranch)
{
  ShortBranches result;
  std::vector<std::size_t> changed;
  const std::vector<std::vector<End>> ends = endsAt(network);
  for (std::size_t j = 0; j < ends.size(); ++j)
  {
    const double radius = probe.radius(network.junctions[j]);
    double worst = minBranch;
    std::size_t shortest = network.branches.size();
    for (const End& end : ends[j])
    {
      const NetworkBranch& branch = network.branches[end.branch];
      if (branch.junctions[1] == NetworkBranch::kFree)
      {
        const double ratio = ratioOf(branch, radius, probe);
        if (ratio < worst)
        {
          worst = ratio;
          shortest = end.branch;
        }
      }
    }
    if (shortest < network.branches.size())
    {
      network.branches[shortest] = {};
      result.removed = true;
      changed.push_back(j);
    }
  }
  if (!result.removed)
  {
    return result;
  }
  std::vector<char> marked(network.branches.size(), 0);
  for (const std::size_t j : changed)
  {
    // Merging changes which ends are where.
    const std::vector<End> left = endsAt(network)[j];
    if (left.size() == 2)
    {
      marked[left[0].branch] = 1;
      merge(network, left[0], left[1]);
    }
  }
  compact(network, marked);
  for (std::size_t b = 0; b < marked.size(); ++b)
  {
    if (marked[b] != 0)
    {
      result.merged.push_back(b);
    }
  }
  return result;
}

} // namespace medial
