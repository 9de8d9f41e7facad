#pragma once

#include "medial/culling/tile_query.h"
#include "medial/medial/crossing.h"
#include "medial/medial/topology/cell_lattice.h"
#include "medial/sites/grid_frame.h"
#include "medial/sites/site_set.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial
{

/// What exact positions are computed from.
struct SampleContext
{
  const SiteSet& sites;
  const GridFrame& frame;
  const TileQuery& query;
  const std::int32_t* closestSites; ///< of all grid points, x fastest
};

/// Grid edges with a point of each, by the faces of a lattice that are dual to them.
class AxisSamples
{
public:
  static constexpr int kNone = -1;

  /// @param points one a crossing, frame coordinates.
  AxisSamples(const CellLattice& lattice, const std::vector<Crossing>& crossings,
    const std::vector<glm::dvec3>& points);

  /// Adds grid edges that no selection has delivered: at the bisector point of the closest sites of
  /// their ends, or in the middle where these are the same.
  void add(const SampleContext& context, const CellLattice& lattice, std::vector<Cell> faces);

  /// Adds the medial point seen from a grid point, for parts thinner than a voxel: the centre of
  /// the ball, of a radius of up to two voxels, that touches the surface at its closest point and
  /// holds no other (shrinking ball: Ma, Bae, Choi, "3D medial axis point approximation using
  /// nearest neighbors and the normal field", 2012).
  /// @return its index.
  int addPoint(const SampleContext& context, const CellLattice& lattice, const glm::ivec3& voxel);

  /// Index of a face's sample or kNone.
  int find(Cell face) const;
  /// Separation angle of the sample's two sites at its point, radians.
  double angle(const SiteSet& sites, int sample) const;

  const std::vector<Crossing>& crossings() const { return crossings_; }
  const glm::dvec3& point(int sample) const { return points_[sample]; }
  std::vector<Crossing> takeCrossings() { return std::move(crossings_); }

private:
  void sortFrom(std::size_t first, const CellLattice& lattice);

  struct Entry
  {
    Cell face;
    int sample;
  };

  std::vector<Crossing> crossings_;
  std::vector<glm::dvec3> points_;
  std::vector<Entry> byFace_; ///< ascending
};

/// The face dual to a crossing, and the crossing without sites of a face.
Cell dualFace(const CellLattice& lattice, const Crossing& crossing);
Crossing dualEdge(const CellLattice& lattice, Cell face);

} // namespace medial
