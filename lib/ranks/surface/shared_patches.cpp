#include "ranks/surface/shared_patches.h"

#include "base/sorted_set.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <tuple>

namespace medial
{
namespace
{

struct CornersOfFace
{
  std::array<int, 3> corners; ///< ascending
  int face;
};

/// A triangle at an edge.
struct FaceSide
{
  int edge;
  int face;
  int corner;  ///< where it starts
  int forward; ///< 1 if it runs from the lower point to the higher, otherwise -1
};

struct Link
{
  int face;
  int corner;
  int other;
  int same;
};

/// A triangle and its neighbours.
struct Step
{
  int patch;
  int face;
  std::array<int, 3> others;
  std::array<int, 3> same;
};

struct Sense
{
  int face;
  int sense;
};

/// Walks through a patch from its first triangle to neighbours, as one process does.
void walk(int patch, const std::map<int, Step>& steps, std::vector<Sense>& found)
{
  std::map<int, int> senses{ { patch, 1 } };
  std::vector<int> members{ patch };
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    const Step& step = steps.at(members[i]);
    for (int edge = 0; edge < 3; ++edge)
    {
      const int sense = -step.same[edge] * senses[members[i]];
      if (step.others[edge] >= 0 && senses.insert({ step.others[edge], sense }).second)
      {
        members.push_back(step.others[edge]);
      }
    }
  }
  for (const auto& [face, sense] : senses)
  {
    found.push_back({ face, sense });
  }
}

} // namespace

SharedPatches::SharedPatches(Communicator& communicator, const DistributedSurface& surface)
  : surface_(surface)
{
  this->findCopies(communicator);
  this->findNeighbours(communicator);
  this->joinHere();
  while (this->joinAcross(communicator))
  {
    this->followRoots(communicator);
    this->renameRoots(communicator);
  }
  this->walkTwisted(communicator);
}

bool SharedPatches::isHere(int face) const
{
  const std::vector<FaceRecord>& faces = surface_.faces();
  return !faces.empty() && face >= faces.front().face && face <= faces.back().face;
}

void SharedPatches::findCopies(Communicator& communicator)
{
  std::vector<CornersOfFace> own;
  for (const FaceRecord& face : surface_.faces())
  {
    own.push_back({ face.corners, face.face });
    std::sort(own.back().corners.begin(), own.back().corners.end());
  }
  std::vector<CornersOfFace> found = delivered(communicator, own,
    [&](const CornersOfFace& face)
    { return homeOf(face.corners[0], surface_.pointCount(), communicator.size()); });
  std::sort(found.begin(), found.end(),
    [](const CornersOfFace& a, const CornersOfFace& b)
    { return std::tie(a.corners, a.face) < std::tie(b.corners, b.face); });
  std::vector<std::array<int, 2>> copies; // and what they are copies of
  for (std::size_t i = 1, first = 0; i < found.size(); ++i)
  {
    first = found[i].corners == found[first].corners ? first : i;
    if (first != i)
    {
      copies.push_back({ found[i].face, found[first].face });
    }
  }
  std::transform(surface_.faces().begin(), surface_.faces().end(), std::back_inserter(originals_),
    [](const FaceRecord& face) { return face.face; });
  for (const auto& [copy, original] : delivered(communicator, copies,
         [&](const std::array<int, 2>& pair) { return surface_.homeOfFace(pair[0]); }))
  {
    originals_[this->indexOf(copy)] = original;
  }
}

void SharedPatches::findNeighbours(Communicator& communicator)
{
  std::vector<FaceSide> own;
  for (std::size_t i = 0; i < surface_.faces().size(); ++i)
  {
    const FaceRecord& face = surface_.faces()[i];
    for (int corner = 0; corner < 3 && !this->isCopy(i); ++corner)
    {
      own.push_back({ face.edges[corner], face.face, corner,
        face.corners[corner] < face.corners[(corner + 1) % 3] ? 1 : -1 });
    }
  }
  std::vector<FaceSide> sides = delivered(communicator, own,
    [&](const FaceSide& side)
    { return homeOf(side.edge, surface_.edgeCount(), communicator.size()); });
  std::sort(sides.begin(), sides.end(),
    [](const FaceSide& a, const FaceSide& b)
    { return std::tie(a.edge, a.face) < std::tie(b.edge, b.face); });
  std::vector<Link> links;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    while (end < sides.size() && sides[end].edge == sides[begin].edge)
    {
      ++end;
    }
    if (end - begin == 2)
    {
      const FaceSide& a = sides[begin];
      const FaceSide& b = sides[begin + 1];
      links.push_back({ a.face, a.corner, b.face, a.forward * b.forward });
      links.push_back({ b.face, b.corner, a.face, a.forward * b.forward });
    }
  }
  neighbours_.resize(surface_.faces().size());
  for (const Link& link : delivered(communicator, links,
         [&](const Link& link) { return surface_.homeOfFace(link.face); }))
  {
    neighbours_[this->indexOf(link.face)][link.corner] = { link.other, link.same };
  }
}

/// Joins the triangles of this rank.
void SharedPatches::joinHere()
{
  const std::size_t count = surface_.faces().size();
  roots_.assign(count, -1);
  senses_.assign(count, 1);
  for (std::size_t seed = 0; seed < count; ++seed)
  {
    parents_.push_back({ surface_.faces()[seed].face, 1 });
    if (roots_[seed] >= 0 || this->isCopy(seed))
    {
      continue;
    }
    roots_[seed] = surface_.faces()[seed].face;
    std::vector<std::size_t> members{ seed };
    while (!members.empty())
    {
      const std::size_t member = members.back();
      members.pop_back();
      for (const Neighbour& neighbour : neighbours_[member])
      {
        if (this->isHere(neighbour.face) && roots_[this->indexOf(neighbour.face)] < 0)
        {
          const std::size_t next = this->indexOf(neighbour.face);
          roots_[next] = roots_[seed];
          senses_[next] = static_cast<std::int8_t>(-neighbour.same * senses_[member]);
          members.push_back(next);
        }
      }
    }
  }
}

std::vector<SharedPatches::Seen> SharedPatches::seenAcross(Communicator& communicator) const
{
  std::vector<Seen> own;
  for (std::size_t i = 0; i < neighbours_.size(); ++i)
  {
    for (const Neighbour& neighbour : neighbours_[i])
    {
      if (neighbour.face >= 0)
      {
        own.push_back({ neighbour.face, roots_[i], -neighbour.same * senses_[i] });
      }
    }
  }
  return delivered(communicator, own,
    [&](const Seen& seen) { return surface_.homeOfFace(seen.face); });
}

/// Hangs roots to lower ones of neighbours.
/// @return whether any rank has done so.
bool SharedPatches::joinAcross(Communicator& communicator)
{
  std::vector<Proposal> proposals;
  for (const Seen& seen : this->seenAcross(communicator))
  {
    const std::size_t i = this->indexOf(seen.face);
    if (seen.root < roots_[i])
    {
      proposals.push_back({ roots_[i], { seen.root, seen.sense * senses_[i] } });
    }
  }
  const auto isLower = [](const Proposal& a, const Proposal& b)
  {
    return std::tie(a.root, a.other.face, a.other.sense) <
      std::tie(b.root, b.other.face, b.other.sense);
  };
  // The lowest for each root.
  std::sort(proposals.begin(), proposals.end(), isLower);
  proposals.erase(std::unique(proposals.begin(), proposals.end(),
                    [](const Proposal& a, const Proposal& b) { return a.root == b.root; }),
    proposals.end());
  proposals = delivered(communicator, proposals,
    [&](const Proposal& proposal) { return surface_.homeOfFace(proposal.root); });
  std::sort(proposals.begin(), proposals.end(), isLower);
  for (const Proposal& proposal : proposals)
  {
    Root& parent = parents_[this->indexOf(proposal.root)];
    if (parent.face == proposal.root)
    {
      parent = proposal.other;
    }
  }
  return maximum(communicator, proposals.empty() ? 0 : 1) != 0;
}

/// Lets roots that hang to others hang to the last of these.
void SharedPatches::followRoots(Communicator& communicator)
{
  bool moved = true;
  while (moved)
  {
    std::vector<std::size_t> hanging;
    std::vector<int> asked;
    for (std::size_t i = 0; i < parents_.size(); ++i)
    {
      if (parents_[i].face != surface_.faces()[i].face)
      {
        hanging.push_back(i);
        asked.push_back(parents_[i].face);
      }
    }
    const std::vector<Root> above = answered(
      communicator, asked, [&](int face) { return surface_.homeOfFace(face); },
      [&](int face) { return parents_[this->indexOf(face)]; });
    bool here = false;
    for (std::size_t k = 0; k < hanging.size(); ++k)
    {
      here = here || above[k].face != asked[k];
      parents_[hanging[k]] = { above[k].face, above[k].sense * parents_[hanging[k]].sense };
    }
    moved = maximum(communicator, here ? 1 : 0) != 0;
  }
}

std::vector<int> SharedPatches::ownRoots() const
{
  std::vector<int> roots;
  std::copy_if(roots_.begin(), roots_.end(), std::back_inserter(roots),
    [](int root) { return root >= 0; });
  makeSet(roots);
  return roots;
}

/// Gives triangles the roots that theirs hang to.
void SharedPatches::renameRoots(Communicator& communicator)
{
  const std::vector<int> asked = this->ownRoots();
  const std::vector<Root> found = answered(
    communicator, asked, [&](int face) { return surface_.homeOfFace(face); },
    [&](int face) { return parents_[this->indexOf(face)]; });
  for (std::size_t i = 0; i < roots_.size(); ++i)
  {
    if (roots_[i] >= 0)
    {
      const Root& root =
        found[std::lower_bound(asked.begin(), asked.end(), roots_[i]) - asked.begin()];
      roots_[i] = root.face;
      senses_[i] = static_cast<std::int8_t>(senses_[i] * root.sense);
    }
  }
}

std::vector<int> SharedPatches::twistedPatches(Communicator& communicator) const
{
  std::vector<int> twisted;
  for (const Seen& seen : this->seenAcross(communicator))
  {
    const std::size_t i = this->indexOf(seen.face);
    if (seen.sense != senses_[i])
    {
      twisted.push_back(roots_[i]);
    }
  }
  const auto homeOfPatch = [&](int patch) { return surface_.homeOfFace(patch); };
  makeSet(twisted);
  twisted = delivered(communicator, twisted, homeOfPatch);
  std::sort(twisted.begin(), twisted.end());
  const std::vector<int> own = this->ownRoots();
  const std::vector<char> isTwisted = answered(communicator, own, homeOfPatch,
    [&](int patch) -> char { return std::binary_search(twisted.begin(), twisted.end(), patch); });
  std::vector<int> result;
  for (std::size_t k = 0; k < own.size(); ++k)
  {
    if (isTwisted[k] != 0)
    {
      result.push_back(own[k]);
    }
  }
  return result;
}

/// Where directions contradict each other, the way that they were passed on decides. One rank
/// follows that of one process, by the numbers of triangles alone.
void SharedPatches::walkTwisted(Communicator& communicator)
{
  const std::vector<int> twisted = this->twistedPatches(communicator);
  std::vector<Step> own;
  for (std::size_t i = 0; i < roots_.size(); ++i)
  {
    if (std::binary_search(twisted.begin(), twisted.end(), roots_[i]))
    {
      Step step{ roots_[i], surface_.faces()[i].face, {}, {} };
      for (int edge = 0; edge < 3; ++edge)
      {
        step.others[edge] = neighbours_[i][edge].face;
        step.same[edge] = neighbours_[i][edge].same;
      }
      own.push_back(step);
    }
  }
  std::map<int, std::map<int, Step>> patches;
  for (const Step& step :
    delivered(communicator, own, [&](const Step& step) { return surface_.homeOfFace(step.patch); }))
  {
    patches[step.patch][step.face] = step;
  }
  std::vector<Sense> senses;
  for (const auto& [patch, steps] : patches)
  {
    walk(patch, steps, senses);
  }
  for (const Sense& sense : delivered(communicator, senses,
         [&](const Sense& sense) { return surface_.homeOfFace(sense.face); }))
  {
    senses_[this->indexOf(sense.face)] = static_cast<std::int8_t>(sense.sense);
  }
}

} // namespace medial
