#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "field/crossing.h"
#include "thinning/cubical_complex.h"

#include <cstdint>
#include <vector>

namespace medial
{

/// The input for exact positions.
struct SampleContext
{
  const AxisGeometry& geometry;
  const std::int32_t* closestSites; ///< of all grid points, x fastest
};

/// Grid edges with a point on each, found by the faces of a complex that are dual to them.
class AxisSamples
{
public:
  static constexpr int kNone = -1;

  AxisSamples(const CubicalComplex& complex, const std::vector<Crossing>& crossings,
    BisectorPoints bisectors);

  /// Adds grid edges that no selection has delivered: at the bisector point of the closest sites of
  /// their ends, or in the middle where these are the same.
  void add(const SampleContext& context, const CubicalComplex& complex,
    std::vector<CubeCell> faces);

  /// Adds the medial point seen from a grid point, for parts thinner than a voxel: the centre of
  /// the ball, of a radius of up to two voxels, that touches the surface at its closest point and
  /// holds no other (shrinking ball: Ma, Bae, Choi, "3D medial axis point approximation using
  /// nearest neighbors and the normal field", 2012).
  /// @return its index.
  int addPoint(const SampleContext& context, const CubicalComplex& complex,
    const glm::ivec3& voxel);

  /// Returns the index of a face's sample, or kNone.
  int find(CubeCell face) const;
  const BisectorPoint& point(int sample) const { return samples_.points[sample]; }
  const BisectorPoints& points() const { return samples_; }

private:
  struct Entry
  {
    CubeCell face;
    int sample;
  };
  static CubeCell faceOf(const Entry& entry) { return entry.face; }

  void sort();

  BisectorPoints samples_;
  std::vector<Entry> byFace_; ///< ascending
  CellRanks ranks_;
};

/// The face dual to a crossing, and the crossing without sites of a face.
CubeCell dualFace(const CubicalComplex& complex, const Crossing& crossing);
Crossing dualEdge(const CubicalComplex& complex, CubeCell face);

} // namespace medial
