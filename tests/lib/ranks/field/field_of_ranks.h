#pragma once

#include "medial/distance_field.h"
#include "medial/ranks.h"

#include "lib/ranks/pieces.h"

#include <cstddef>
#include <vector>

// Fields that ranks compute, compared with those of one process.
namespace medial::test
{

/// What is computed by ranks and compared with one process.
struct FieldCase
{
  TriangleMesh mesh;
  Grid grid;
  SignMethod sign = SignMethod::Pseudonormal;
};

DistanceFieldOptions optionsOf(const FieldCase& of);
/// The field that one process computes.
DistanceField wholeFieldOf(const FieldCase& of);

/// The arrays of a field of some extent, which it keeps together.
class KeepingSink : public FieldSink
{
public:
  explicit KeepingSink(const Extent& extent)
    : extent_(extent)
  {
    const auto count = static_cast<std::size_t>(extent.pointCount());
    field.distance.resize(count);
    field.closestPoint.resize(3 * count);
    field.closestSite.resize(count);
    field.closestFeature.resize(count);
    field.closestCell.resize(count);
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    const std::ptrdiff_t first =
      static_cast<std::ptrdiff_t>(slab.min[2] - extent_.min[2]) * extent_.size(0) * extent_.size(1);
    return { field.distance.data() + first, field.closestPoint.data() + 3 * first,
      field.closestSite.data() + first, field.closestFeature.data() + first,
      field.closestCell.data() + first };
  }
  void stored(const Extent& /*slab*/) override {}
  std::size_t bytesPerPoint() const override { return 0; }

  DistanceField field;

private:
  Extent extent_;
};

/// Number of grid points of an extent whose values differ from those of the whole field.
std::size_t differences(const DistanceField& whole, const Extent& extent,
  const DistanceField& part);

/// Expects the field of ranks to be that of one process, and returns what the ranks have held.
std::vector<RankCounts> expectSameBits(const FieldCase& of, const DistanceField& whole,
  const std::vector<Extent>& extents, const Distribution& rankOf);

} // namespace medial::test
