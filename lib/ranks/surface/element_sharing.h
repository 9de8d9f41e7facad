#pragma once

#include "culling/element_order.h"
#include "ranks/collective.h"
#include "ranks/surface/distributed_surface.h"
#include "sites/local_coordinates.h"

#include <array>
#include <vector>

namespace medial
{

/// An element of a distributed surface.
struct SharedElement
{
  ElementPlace place; ///< its site is the number of the face in the whole surface
  std::array<int, 3> corners;
  float radius;  ///< of its bounding ball
  int sizeClass; ///< as SizeClasses
  int first;     ///< number of the first element of its part of the order
};

/// The tree of elements of one size class, cut into blocks of elements in a row.
struct BlockedTree
{
  int sizeClass;
  int count;     ///< elements
  int blockSize; ///< elements of a block: 8, 64, 512, ...

  int blocks() const { return (count + blockSize - 1) / blockSize; }
};

/// Elements in the order of the whole surface's tree, shared out by blocks.
struct SharedElements
{
  std::vector<BlockedTree> trees;      ///< the same on every rank, by size
  std::vector<SharedElement> elements; ///< of this rank's blocks, in their order

  /// Returns the rank that has a block, counted over all trees: blocks come in runs of about as
  /// many elements.
  int home(int block, int ranks) const;
};

/// Sorts the elements of a surface as one process does, though no rank has all of them. Every rank
/// calls it.
SharedElements shareElements(Communicator& communicator, const DistributedSurface& surface,
  const LocalCoordinates& frame);

} // namespace medial
