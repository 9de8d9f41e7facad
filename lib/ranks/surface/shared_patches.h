#pragma once

#include "ranks/surface/distributed_surface.h"

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// The patches of a distributed surface, as findPatches() finds them in one process: pieces that
/// are connected through edges of two triangles, each with one direction. A patch is named by its
/// first triangle. Each rank knows those of its own triangles.
class SharedPatches
{
public:
  /// Every rank calls it.
  /// @param surface must outlive this.
  SharedPatches(Communicator& communicator, const DistributedSurface& surface);

  ///@{
  /// For each of the rank's triangles.
  bool isCopy(std::size_t i) const { return originals_[i] != surface_.faces()[i].face; }
  int originalOf(std::size_t i) const { return originals_[i]; } ///< itself, if it is no copy
  int patchOf(std::size_t i) const { return roots_[i]; }
  int senseOf(std::size_t i) const { return senses_[i]; } ///< 1 as it is, -1 turned round
  ///@}

private:
  /// The only other triangle at an edge that is no copy.
  struct Neighbour
  {
    int face = -1; ///< -1 for none
    int same = 0;  ///< 1 if both run along the edge in the same direction, otherwise -1
  };
  using Neighbours = std::array<Neighbour, 3>; ///< in the order of edges

  /// A triangle as its neighbour on another rank sees it.
  struct Seen
  {
    int face; ///< the neighbour
    int root;
    int sense;
  };
  struct Root
  {
    int face;
    int sense; ///< of what hangs there, as seen from the root
  };
  struct Proposal
  {
    int root;
    Root other;
  };

  std::size_t indexOf(int face) const { return surface_.indexOf(face); }
  bool isHere(int face) const;
  void findCopies(Communicator& communicator);
  void findNeighbours(Communicator& communicator);
  void joinHere();
  /// Returns the roots of the triangles here, ascending, each once.
  std::vector<int> ownRoots() const;
  /// Returns what neighbours on other ranks know of the triangles here.
  std::vector<Seen> seenAcross(Communicator& communicator) const;
  bool joinAcross(Communicator& communicator);
  void followRoots(Communicator& communicator);
  void renameRoots(Communicator& communicator);
  void walkTwisted(Communicator& communicator);
  /// Returns the patches that cannot have a direction, of those with triangles here.
  std::vector<int> twistedPatches(Communicator& communicator) const;

  const DistributedSurface& surface_;
  std::vector<int> originals_; ///< the first triangle with the same corners
  std::vector<Neighbours> neighbours_;
  std::vector<int> roots_;
  std::vector<std::int8_t> senses_;
  std::vector<Root> parents_; ///< of triangles that have been roots
};

} // namespace medial
