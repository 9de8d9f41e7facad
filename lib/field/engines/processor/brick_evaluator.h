#pragma once

#include "base/simd.h"
#include "culling/group_list.h"
#include "culling/group_tree.h"
#include "field/tile_field.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{

/// Finds closest sites where a tile has many candidates. It cuts the tile into bricks of 4 x 4 x 4
/// grid points and these into cubes of 2 x 2 x 2. A brick tests its eight cubes side by side
/// against the Voronoi regions of an element's sites, and evaluates a site at the eight points of
/// those cubes that its region meets.
class BrickEvaluator
{
public:
  /// @param tree must outlive this.
  /// @param slack bound of the rounding of single precision, local units.
  BrickEvaluator(const GroupTree& tree, const GridFrame& frame, float slack);

  /// Memory of one thread.
  struct Workspace;

  /// Finds the closest sites of a tile; of sites at equal distance those of the lowest element. A
  /// point that all bounds exclude gets none, -1.
  /// @param reach of the tile.
  /// @param slices of the tile that are needed. Their values do not depend on which these are.
  /// @return number of pairs of a grid point and a site that were evaluated.
  std::int64_t evaluate(const Extent& tile, const BoxReach& reach, const GroupList& candidates,
    const SliceRange& slices, TileField& field, Workspace& workspace) const;

private:
  struct Brick;
  struct CubeField;

  /// Copies the elements that can be closest in the tile to the workspace, and returns how many.
  int pack(const BoxReach& reach, const GroupList& candidates, Workspace& workspace) const;
  void listElements(Brick& brick) const;
  /// Returns the squared distances within which the sites of the cubes' points are.
  Float8 testCubes(Brick& brick) const;
  std::int64_t evaluateCubes(Brick& brick, Float8 reach, CubeField* cubes) const;
  std::int64_t evaluateBrick(Brick& brick, CubeField* cubes) const;
  void findSites(const Brick& brick, CubeField* cubes) const;
  static void store(const CubeField* cubes, const glm::ivec3& corner, TileField& field);

  const GroupTree& tree_;
  GridFrame frame_;
  glm::vec3 step_;
  float slack_;
};

/// Memory of one thread.
struct BrickEvaluator::Workspace
{
  /// How eight elements of a pack can be closest in a brick.
  struct alignas(32) Near
  {
    Float8 squared; ///< distances from the middle
    Int8 parts;     ///< sites, as bits of SitePart
  };
  /// How an element can be closest in the cubes of a brick.
  struct alignas(32) CubeElement
  {
    PlanePosition centres; ///< of the cubes, in the element's plane
    Float8 squared;        ///< distances from them
    Int8 parts;            ///< sites, as bits of SitePart
    int index;             ///< of the element in the packs
  };

  std::vector<std::pair<int, int>> order; ///< elements of the tile, and where they are
  std::vector<SiteGroup> packs;           ///< the elements, relative to the middle of the tile
  std::vector<Near> near;                 ///< for every pack
  std::vector<CubeElement> elements;      ///< those near the brick
};

} // namespace medial
