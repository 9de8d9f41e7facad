#pragma once

#include "culling/group_tree.h"
#include "ranks/surface/surface_part.h"

#include <cstddef>
#include <vector>

// Nodes of the trees of a distributed surface, as they pass between ranks.
namespace medial
{

///@{
/// A group, or a pack of discs, of one rank.
struct GroupRecord
{
  int tree;
  SparseTree::Group group; ///< its elements are numbers in the whole surface
};
struct PackRecord
{
  int tree;
  int level;
  SparseTree::Pack pack;
};
///@}

/// Returns the trees of some groups and packs, which come in any order, several times, and of packs
/// with more than lie above the groups. Trees without groups are left out.
/// @param trees number of them.
std::vector<SparseTree> treesOf(const std::vector<GroupRecord>& groups,
  const std::vector<PackRecord>& packs, std::size_t trees);

/// Names the elements of groups by their triangles in a part.
void nameByPart(const SurfacePart& part, std::vector<SparseTree>& trees);

} // namespace medial
