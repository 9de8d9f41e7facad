#pragma once

#include "ranks/surface/distributed_surface.h"
#include "ranks/surface/shared_patches.h"
#include "ranks/surface/shared_rim.h"
#include "sign/containment.h"
#include "sign/patch_measure.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace medial
{

/// How the triangles of a distributed surface count for the solid that it stands for, as
/// orientSurface() decides in one process, to the last bit. Each rank knows it of its own
/// triangles, and decides about the patches whose first triangle it has.
class SharedOrientation
{
public:
  /// Every rank calls it.
  /// @param surface must outlive this.
  SharedOrientation(Communicator& communicator, const DistributedSurface& surface);

  /// For each of the rank's triangles 1 as it is, -1 turned round, 0 for the copy of an earlier
  /// one.
  const std::vector<std::int8_t>& weights() const { return weights_; }

  ///@{
  /// Of the whole surface.
  std::int64_t copies() const { return counts_[0]; }
  std::int64_t turned() const { return counts_[1]; } ///< triangles turned round
  std::int64_t rimEdges() const { return counts_[2]; }
  ///@}

  /// Returns the edges of the whole rim, ascending. Every rank calls it.
  std::vector<SharedRimEdge> wholeRim(Communicator& communicator) const;

  /// Returns how triangles count, by their numbers. Every rank calls it, with any of them.
  std::vector<std::int8_t> weightsOf(Communicator& communicator,
    const std::vector<int>& faces) const;
  /// Returns which triangles are turned round, by their numbers: 1 as it is, -1 turned round;
  /// copies face the way of the triangle that counts. Every rank calls it, with any of them.
  std::vector<std::int8_t> directionsOf(Communicator& communicator,
    const std::vector<int>& faces) const;

private:
  /// Places on patches.
  struct Probes
  {
    std::vector<int> patches;
    std::vector<glm::dvec3> places;
  };
  /// What is known of a patch where it is decided about.
  struct Patch
  {
    std::vector<std::array<int, 2>> members; ///< ranks with triangles of it, and how many
    bool alike = true;                       ///< whether all of these face the same way
    double majority = 0.0;
    std::optional<glm::dvec3> origin;
    PatchMeasure measure;
    std::vector<CountedTriangle> lids;
    int container = -1; ///< the smallest solid around it, of those that count; -1 for none
    bool turned = false;

    std::size_t triangles() const;
  };
  /// A patch as another rank sees it.
  struct Size
  {
    int patch;
    double volume;

    bool operator<(const Size& other) const
    {
      return volume != other.volume ? volume < other.volume : patch < other.patch;
    }
  };
  /// What to do with the triangles of a patch on a rank.
  struct Order
  {
    int rank;
    int patch;
    int turn; ///< -1 to turn them round
    bool solid;
  };
  struct Sums;

  /// Where an item of a patch is decided about.
  int homeOfPatch(int patch) const { return surface_.homeOfFace(patch); }
  glm::dvec3 aroundMiddle(const Point3& point) const;
  std::array<glm::dvec3, 3> cornersOf(std::size_t i) const;
  /// Calls visit(i) for the rank's triangles of a patch, ascending.
  template <typename Visit>
  void forMembers(int patch, const Visit& visit) const;

  void collectPatches(Communicator& communicator);
  void sumUp(Communicator& communicator);
  void add(Sums& sums) const;
  void closePatches(Communicator& communicator);
  void findContainers(Communicator& communicator);
  Probes ownProbes(Communicator& communicator) const;
  std::vector<SolidTriangle> solidTriangles() const;
  /// @param patches of places.
  /// @param around the solids around each of these.
  void chooseContainers(Communicator& communicator, const std::vector<int>& patches,
    const std::vector<std::vector<int>>& around);
  void turnSolids(Communicator& communicator);
  /// Turns the triangles of patches, and tells their ranks which are solid.
  template <typename Turns>
  void turn(Communicator& communicator, const Turns& turns);
  std::vector<std::int8_t> ownDirections(Communicator& communicator) const;
  std::vector<CountedFace> countedFaces(bool asOnePatch) const;

  const DistributedSurface& surface_;
  SharedPatches patches_;
  std::vector<std::int8_t> weights_;
  std::vector<std::pair<int, int>> members_; ///< patch and index of a triangle, ascending
  std::vector<int> solids_;                  ///< patches of triangles here, ascending
  std::map<int, Patch> decided_;             ///< those that this rank decides about
  std::vector<SharedRimEdge> rim_;           ///< in this rank's share of edges
  std::array<std::int64_t, 3> counts_{};
};

} // namespace medial
