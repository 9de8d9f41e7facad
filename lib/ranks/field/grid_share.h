#pragma once

#include "base/extents.h"
#include "field/crossing.h"
#include "medial/grid.h"
#include "ranks/collective.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Which rank has which part of a grid, as one of them sees it. A grid cell belongs to the rank
/// that has its lowest point; cells beyond the grid belong to that of the nearest one.
class GridShare
{
public:
  /// @param extents of all ranks.
  /// @throws Error InvalidInput unless they cover the grid, each point once.
  GridShare(const Grid& grid, std::vector<Extent> extents, int rank);

  const Extent& whole() const { return whole_; }
  /// What a rank has; may be empty.
  const Extent& of(int rank) const { return extents_[rank]; }
  /// What this rank has; may be empty.
  const Extent& own() const { return extents_[rank_]; }
  bool owns(const glm::ivec3& cell) const { return hasPoint(this->own(), this->nearest(cell)); }
  int ownerOf(const glm::ivec3& cell) const;
  /// What a rank has and a halo of some points around; empty if it has nothing.
  Extent withHalo(int rank, int halo) const;
  Extent withHalo(int halo) const { return this->withHalo(rank_, halo); }

  /// Gives each rank what lies in its part, in the order of ranks. Every rank calls it.
  /// @param items of this rank, anywhere.
  /// @param cellOf returns the cell of an item.
  template <typename Item, typename CellOf>
  std::vector<Item> toOwners(Communicator& communicator, const std::vector<Item>& items,
    const CellOf& cellOf) const
  {
    int owner = rank_; // of most items that of the one before
    return delivered(communicator, items,
      [&](const Item& item)
      {
        const glm::ivec3 point = this->nearest(cellOf(item));
        owner = hasPoint(extents_[owner], point) ? owner : this->ownerOf(point);
        return owner;
      });
  }

  /// Gives all ranks what lies in their parts and a halo around, in the order of ranks. Every rank
  /// calls it.
  /// @param own what lies in this rank's part.
  /// @param cellOf returns the cell of an item.
  template <typename Item, typename CellOf>
  std::vector<Item> spread(Communicator& communicator, const std::vector<Item>& own, int halo,
    const CellOf& cellOf) const
  {
    RankLists<Item> lists(extents_.size());
    for (std::size_t rank = 0; rank < extents_.size(); ++rank)
    {
      const Extent wanted = this->withHalo(static_cast<int>(rank), halo);
      if (meet(wanted, this->own()))
      {
        std::copy_if(own.begin(), own.end(), std::back_inserter(lists[rank]),
          [&](const Item& item) { return hasPoint(wanted, this->nearest(cellOf(item))); });
      }
    }
    return flattened(exchanged(communicator, std::move(lists)));
  }

private:
  static bool meet(const Extent& a, const Extent& b);
  glm::ivec3 nearest(const glm::ivec3& cell) const;

  Extent whole_;
  std::vector<Extent> extents_;
  int rank_;
};

/// Numbers in the order in which one process makes crossings and vertices of the dual mesh.
class AxisOrder
{
public:
  explicit AxisOrder(const Grid& grid);

  /// @return in [0, span()).
  std::int64_t ofCrossing(const Crossing& crossing) const;
  /// @param cell of the dual mesh; may lie just outside the grid.
  /// @return in [0, span()).
  std::int64_t ofVertex(const glm::ivec3& cell, bool inside) const;
  std::int64_t span() const;

private:
  glm::ivec3 size_;
};

} // namespace medial
