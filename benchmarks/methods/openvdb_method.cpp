#include "methods/field_method.h"
#include "methods/grid_blocks.h"

#include "base/stopwatch.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/MeshToVolume.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <cmath>
#include <limits>

namespace medial::benchmark
{
namespace
{

using openvdb::Vec3I;
using openvdb::Vec3s;

/// A mesh in index space: grid point (i, j, k) is at (i, j, k).
struct IndexMesh
{
  std::vector<Vec3s> points;
  std::vector<Vec3I> triangles;
};

IndexMesh makeIndexMesh(const TriangleMesh& mesh, const Grid& grid)
{
  IndexMesh result;
  for (const Point3& p : mesh.points)
  {
    Vec3s point;
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = static_cast<float>((p[axis] - grid.origin[axis]) / grid.spacing[axis]);
    }
    result.points.push_back(point);
  }
  for (const auto& t : mesh.triangles)
  {
    result.triangles.emplace_back(t[0], t[1], t[2]);
  }
  return result;
}

/// The width of a band, in voxels, that surely covers the grid and is not much wider: the largest
/// distance of a coarse set of grid points to the mesh's points, plus how far others can be from
/// that set.
float wholeGridBand(const IndexMesh& mesh, const Grid& grid)
{
  constexpr int kSteps = 8;
  const auto coordinate = [&](int axis, int step)
  { return static_cast<float>(step) * static_cast<float>(grid.dimensions[axis] - 1) / kSteps; };
  const auto farthest = [&](const tbb::blocked_range<int>& range, float most)
  {
    for (int i = range.begin(); i != range.end(); ++i)
    {
      const Vec3s place(coordinate(0, i % (kSteps + 1)),
        coordinate(1, i / (kSteps + 1) % (kSteps + 1)),
        coordinate(2, i / (kSteps + 1) / (kSteps + 1)));
      float nearest = std::numeric_limits<float>::infinity();
      for (const Vec3s& point : mesh.points)
      {
        nearest = std::min(nearest, (point - place).lengthSqr());
      }
      most = std::max(most, nearest);
    }
    return most;
  };
  constexpr int kPlaces = (kSteps + 1) * (kSteps + 1) * (kSteps + 1);
  const float squared = tbb::parallel_reduce(tbb::blocked_range<int>(0, kPlaces), 0.0F, farthest,
    [](float a, float b) { return std::max(a, b); });
  const Vec3s cell(coordinate(0, 1), coordinate(1, 1), coordinate(2, 1));
  return std::sqrt(squared) + 0.5F * cell.length() + 2.0F;
}

class OpenVdbMethod final : public FieldMethod
{
public:
  explicit OpenVdbMethod(int bandVoxels)
    : bandVoxels_(bandVoxels)
  {
    openvdb::initialize();
  }

  std::string name() const override
  {
    const std::string version = std::to_string(OPENVDB_LIBRARY_MAJOR_VERSION_NUMBER) + "." +
      std::to_string(OPENVDB_LIBRARY_MINOR_VERSION_NUMBER);
    return "OpenVDB " + version +
      (bandVoxels_ > 0 ? ", band of " + std::to_string(bandVoxels_) : ", whole grid");
  }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    FieldResult result;
    const float band = bandVoxels_ > 0 ? static_cast<float>(bandVoxels_)
                                       : wholeGridBand(makeIndexMesh(mesh, grid), grid);
    double convert = 0.0;
    double copy = 0.0;
    openvdb::FloatGrid::Ptr volume;
    openvdb::Int32Grid nearest(static_cast<openvdb::Int32>(openvdb::util::INVALID_IDX));
    timed(convert,
      [&]
      {
        const IndexMesh input = makeIndexMesh(mesh, grid);
        const openvdb::tools::QuadAndTriangleDataAdapter<Vec3s, Vec3I> adapter(input.points,
          input.triangles);
        const auto transform = openvdb::math::Transform::createLinearTransform(grid.spacing[0]);
        volume = openvdb::tools::meshToVolume<openvdb::FloatGrid>(adapter, *transform, band, band,
          openvdb::tools::UNSIGNED_DISTANCE_FIELD, &nearest);
      });
    timed(copy, [&] { this->copyToArrays(*volume, nearest, grid, result); });
    result.seconds = { { "convert", convert }, { "copy", copy } };
    result.figures = { { "band_voxels", static_cast<double>(band) } };
    return result;
  }

private:
  /// NaN and -1 outside the band.
  static void copyToArrays(const openvdb::FloatGrid& volume, const openvdb::Int32Grid& nearest,
    const Grid& grid, FieldResult& result)
  {
    const auto count = static_cast<std::size_t>(grid.pointCount());
    result.distance.resize(count);
    result.triangle.resize(count);
    // Aligned with OpenVDB's leaves of 8 x 8 x 8, so that accessors stay in one.
    const std::vector<Extent> blocks = mortonBlocks(grid);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, blocks.size()),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        const auto distances = volume.getConstAccessor();
        const auto triangles = nearest.getConstAccessor();
        for (std::size_t block = range.begin(); block != range.end(); ++block)
        {
          serpentine(blocks[block],
            [&](int i, int j, int k)
            {
              const openvdb::Coord at(i, j, k);
              const std::size_t index = pointIndex(grid, i, j, k);
              float distance = 0.0F;
              const bool known = distances.probeValue(at, distance);
              result.distance[index] = known ? distance : std::numeric_limits<float>::quiet_NaN();
              result.triangle[index] = known ? triangles.getValue(at) : -1;
            });
        }
      });
  }

  int bandVoxels_;
};

} // namespace

std::unique_ptr<FieldMethod> makeOpenVdbMethod(int bandVoxels)
{
  return std::make_unique<OpenVdbMethod>(bandVoxels);
}

} // namespace medial::benchmark
