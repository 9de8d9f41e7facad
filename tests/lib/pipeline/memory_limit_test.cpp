// Slabs, whose thickness follows from the memory limit, change no byte of what the processor
// computes.
#include "medial/compute_distance_field.h"
#include "medial/compute_medial_axis.h"

#include "field/array_sink.h"
#include "support/medial_truth.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

constexpr std::size_t kMiB = 1024 * 1024;

/// Takes a field as if it held so much of a slab that a MiB allows only thin ones.
class HeavySink : public ArraySink
{
public:
  HeavySink(const Extent& extent, const FieldArrays& arrays, int slices)
    : ArraySink(extent, arrays)
    , bytes_(kMiB / (static_cast<std::size_t>(slices) * extent.size(0) * extent.size(1)))
  {
  }

  FieldArrays slabArrays(const Extent& slab) override
  {
    thickest = std::max(thickest, slab.size(2));
    return ArraySink::slabArrays(slab);
  }
  std::size_t bytesPerPoint() const override { return bytes_; }

  int thickest = 0;

private:
  std::size_t bytes_;
};

struct Field
{
  explicit Field(const Grid& grid)
    : distance(static_cast<std::size_t>(grid.pointCount()))
    , closestPoint(3 * distance.size())
    , closestSite(distance.size())
    , closestCell(distance.size())
  {
  }

  FieldArrays arrays()
  {
    return { distance.data(), closestPoint.data(), closestSite.data(), nullptr,
      closestCell.data() };
  }

  bool operator==(const Field& other) const
  {
    return distance == other.distance && closestPoint == other.closestPoint &&
      closestSite == other.closestSite && closestCell == other.closestCell;
  }

  std::vector<float> distance;
  std::vector<float> closestPoint;
  std::vector<std::int32_t> closestSite;
  std::vector<std::int64_t> closestCell;
};

/// Flat voxels, so that nothing is round; more slices than the thickest slab.
Grid gridOf(const TriangleMesh& mesh)
{
  return makeGridWithSpacing(mesh.bounds(), { 0.037, 0.041, 0.019 }, 0.1);
}

bool sameAxis(const MedialAxis& a, const MedialAxis& b)
{
  return a.points == b.points && a.radius == b.radius && a.separationAngle == b.separationAngle &&
    a.lambda == b.lambda && a.closestPointA == b.closestPointA &&
    a.closestPointB == b.closestPointB && a.feature == b.feature && a.quads == b.quads &&
    a.triangles == b.triangles && a.lines == b.lines && a.vertices == b.vertices;
}

class MemoryLimit : public testing::TestWithParam<int>
{
protected:
  /// The field, and the axis where that is wanted, with slabs of at most some slices.
  std::pair<Field, MedialAxis> computed(int slices, bool axis)
  {
    Field field(grid_);
    HeavySink sink(grid_.wholeExtent(), field.arrays(), slices);
    MedialAxisOptions options;
    options.field.memoryMiB = 1;
    const MeshConnectivity connectivity = analyseConnectivity(mesh_);
    MedialAxis result;
    if (axis)
    {
      result = computeMedialAxis(mesh_, connectivity, grid_, options, sink);
    }
    else
    {
      computeDistanceField(mesh_, connectivity, grid_, grid_.wholeExtent(), sink, options.field);
    }
    EXPECT_LE(sink.thickest, slices);
    return { field, result };
  }

  const TriangleMesh mesh_ = appended(tilted(lPrism(1.0, 0.6)), tilted(torus(1.3, 0.1, 30, 9)));
  const Grid grid_ = gridOf(mesh_);
};

} // namespace

TEST_P(MemoryLimit, ChangesNothingInFields)
{
  Field whole(grid_);
  computeDistanceField(mesh_, analyseConnectivity(mesh_), grid_, grid_.wholeExtent(),
    whole.arrays());
  EXPECT_TRUE(computed(GetParam(), false).first == whole);
}

TEST_P(MemoryLimit, ChangesNothingInAxes)
{
  Field whole(grid_);
  const MedialAxis axis =
    computeMedialAxis(mesh_, analyseConnectivity(mesh_), grid_, {}, whole.arrays());
  ASSERT_GT(axis.points.size(), 1000u);
  const auto [field, other] = computed(GetParam(), true);
  EXPECT_TRUE(sameAxis(axis, other));
  EXPECT_TRUE(field == whole);
}

INSTANTIATE_TEST_SUITE_P(Slices, MemoryLimit, testing::Values(1, 2, 4, 8, 16, 32));
