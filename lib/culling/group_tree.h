#pragma once

#include "culling/discs.h"
#include "culling/group_list.h"
#include "culling/site_group.h"
#include "sites/closest_point.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace medial
{

/// Returns a bound of the rounding of single precision near a mesh, local units.
/// @param reach how far from the local origin positions are, local units.
/// @param farthest how far from it the points of the mesh are, local units.
float roundingNear(double reach, double farthest);
float roundingNear(double reach, const SiteSet& sites);

/// Some groups of a tree of elements of about the same size, and the nodes above them.
struct SparseTree
{
  struct Group
  {
    int number;                                 ///< in the whole tree
    int count;                                  ///< of its elements
    std::array<int, SiteGroup::kSize> elements; ///< sites that name them, ascending
  };
  struct Pack
  {
    int number; ///< in its level of the whole tree
    Discs discs;
  };

  std::vector<Group> groups;             ///< ascending
  std::vector<std::vector<Pack>> levels; ///< ascending; the first holds the discs of groups
};

/// Eight groups whose discs lie side by side in a tree.
struct GroupPack
{
  const Discs* discs;
  const int* places; ///< of the groups after the first; null if they follow each other
  int first;
  unsigned lanes; ///< the groups that are meant, as bits

  /// Returns the group of a lane.
  int group(int lane) const { return first + (places != nullptr ? places[lane] : lane); }
};

/// A linear tree over the elements of a mesh. Its leaves are the groups: elements are sorted so
/// that any 2^k of them, from a multiple of 2^k on, are close together, and eight in a row make a
/// group. Every level above has a disc for every eight nodes of the level below.
///
/// Elements much larger than most have trees of their own, so that they widen no other disc.
class GroupTree
{
public:
  /// @param sites must outlive this.
  /// @param slack bound of the rounding of single precision near the grid and the mesh, by which
  ///   discs are widened; local units.
  GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack);
  /// The same over some elements, with the sites that they own.
  GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack,
    const std::vector<int>& elements);

  /// A part of a larger mesh's tree: some of its groups, with all nodes above them. Where these
  /// groups suffice, it finds what the whole tree finds, to the last bit.
  /// @param sites of a mesh that has the groups' elements and all triangles around their points.
  /// @param slack of the whole tree.
  /// @param trees by size of their elements.
  GroupTree(const SiteSet& sites, const MeshConnectivity& connectivity, float slack,
    const std::vector<SparseTree>& trees);

  const SiteSet& sites() const { return sites_; }
  /// Bound of the rounding of single precision near the grid and the mesh, local units.
  float slack() const { return slack_; }
  const std::vector<SiteGroup>& groups() const { return groups_; }

  /// Returns the element nearest to a position, in single precision.
  /// @param start some element; the nearer it is, the faster the search.
  NearestElement nearest(const glm::dvec3& x, const NearestElement& start = {}) const;

  /// Calls visit(group) for the groups whose discs are within a distance of a position, the nearer
  /// of a node's children first.
  /// @param limit returns the squared distance, which may fall meanwhile.
  template <typename Limit, typename Visit>
  void visitNear(const glm::vec3& x, const Limit& limit, const Visit& visit) const;

  /// Lists the groups that may hold the closest point of some position in a box, in ascending
  /// order.
  /// @return number of discs that were tested.
  int collect(const BoxReach& reach, GroupList& found) const;
  /// The same, without a copy of their discs.
  int collect(const BoxReach& reach, std::vector<GroupPack>& found) const;

private:
  /// The tree of elements of about the same size.
  struct SizeTree
  {
    int firstGroup;
    std::vector<std::vector<Discs>> levels; ///< the first holds the discs of groups
    /// Where the nodes below those of each level are; empty where each has eight.
    std::vector<std::vector<std::array<int, kLanes>>> children;

    int child(int level, int index, int lane) const
    {
      return children.empty() ? index * kLanes + lane : children[level][index][lane];
    }
  };
  /// A node to look at.
  struct Node
  {
    int level; ///< that of its discs, or -1 for a group
    int index;
    float squared; ///< distance
  };
  /// The nodes still to be looked at. A node is taken away before the eight below it are added, so
  /// each level adds seven at most.
  struct Stack
  {
    std::array<Node, 16 * kLanes> nodes;
    int count = 0;

    void push(const Node& node) { nodes[count++] = node; }
    Node pop() { return nodes[--count]; }
  };

  /// Pushes the nodes below another whose discs are within a squared distance, the nearest last.
  static void pushNear(const SizeTree& tree, const glm::vec3& x, float limit, const Node& parent,
    Stack& stack);

  /// Calls found(pack) for the packs of groups that may hold the closest point of some position in
  /// a box.
  /// @return number of discs that were tested.
  template <typename Found>
  int visitMet(const BoxReach& reach, const Found& found) const;

  void addSparse(const SparseTree& sparse, const SharedSites& shared);
  void addTrees(const std::vector<int>& elements, const SharedSites& shared);
  void addTree(std::vector<int>& elements, const SharedSites& shared, float slack);

  const SiteSet& sites_;
  float slack_;
  std::vector<SiteGroup> groups_;
  std::vector<SizeTree> trees_;
};

template <typename Limit, typename Visit>
void GroupTree::visitNear(const glm::vec3& x, const Limit& limit, const Visit& visit) const
{
  Stack stack;
  for (const SizeTree& tree : trees_)
  {
    stack.push({ static_cast<int>(tree.levels.size()) - 1, 0, 0.0f });
    while (stack.count > 0)
    {
      const Node node = stack.pop();
      if (node.squared > limit())
      {
        continue;
      }
      if (node.level < 0)
      {
        visit(tree.firstGroup + node.index);
        continue;
      }
      pushNear(tree, x, limit(), node, stack);
    }
  }
}

/// Adds the surface points nearest to the corners of a box to its reach.
/// @param found nearest to its centre.
/// @param nearest a NearestElement(const glm::dvec3& x, const NearestElement& start).
template <typename Nearest>
void addCorners(const GroupTree& tree, NearestElement found, const Nearest& nearest,
  BoxReach& reach)
{
  const FrameBox& box = reach.box();
  for (int i = 0; i < FrameBox::kCorners; ++i)
  {
    const glm::dvec3 corner = glm::dvec3(box.centre) + glm::dvec3(box.corner(i));
    NearestElement start;
    start.tryGroup(tree.groups(), found.group, corner);
    found = nearest(corner, start);
    const int element = tree.groups()[found.group].elements[found.lane];
    reach.add(glm::vec3(closestPoint(tree.sites(), element, corner).point));
  }
}

/// Lists those of some groups that may hold the closest point of some position in a box.
/// @param nearest set to the element nearest to the centre.
inline BoxReach refine(const GroupTree& tree, const GroupList& groups, const FrameBox& box,
  NearestElement& nearest, GroupList& found)
{
  const auto nearestTo = [&](const glm::dvec3& x, const NearestElement& start)
  { return groups.nearest(tree.groups(), x, start); };
  nearest = nearestTo(glm::dvec3(box.centre), {});
  BoxReach reach(box, nearest, tree.slack());
  addCorners(tree, nearest, nearestTo, reach);
  groups.refine(reach, found);
  return reach;
}

} // namespace medial
