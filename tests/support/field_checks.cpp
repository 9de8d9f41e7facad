#include "support/field_checks.h"

#include "medial/compute_distance_field.h"
#include "medial/device.h"
#include "support/brute_force.h"
#include "support/printing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <numeric>
#include <random>
#include <sstream>

namespace medial::test
{

namespace
{

constexpr double kTolerance = 1e-2;
constexpr double kUsualTolerance = 1e-3;
/// One voxel in so many may exceed the usual tolerance.
constexpr std::size_t kRare = 10000;

double length(const Point3& a, const Point3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Feature kindOfSite(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  std::int64_t site)
{
  const std::size_t faces = mesh.triangles.size();
  const auto id = static_cast<std::size_t>(site);
  return id < faces ? Feature::Face
                    : (id < faces + connectivity.edges.size() ? Feature::Edge : Feature::Vertex);
}

/// Distance to input cells, each found without a search.
class CellDistance
{
public:
  explicit CellDistance(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
    const auto add = [this](const std::vector<std::int64_t>& ids, int kind)
    {
      for (std::size_t i = 0; i < ids.size(); ++i)
      {
        parts_[ids[i]].push_back({ kind, i });
      }
    };
    add(mesh.triangleCells, 3);
    add(mesh.segmentCells, 2);
    add(mesh.vertexCells, 1);
  }

  double operator()(std::int64_t cell, const Point3& query) const
  {
    const auto found = parts_.find(cell);
    double min = std::numeric_limits<double>::infinity();
    if (found != parts_.end())
    {
      for (const auto& [kind, index] : found->second)
      {
        min = std::min(min, this->toPart(kind, index, query));
      }
    }
    return min;
  }

private:
  double toPart(int kind, std::size_t index, const Point3& query) const
  {
    const auto& p = mesh_.points;
    if (kind == 1)
    {
      return length(p[mesh_.vertices[index]], query);
    }
    if (kind == 2)
    {
      const auto& s = mesh_.segments[index];
      return closestOnSegment(p[s[0]], p[s[1]], query).distance;
    }
    const auto& t = mesh_.triangles[index];
    return closestOnTriangle(p[t[0]], p[t[1]], p[t[2]], query).distance;
  }

  const TriangleMesh& mesh_;
  std::map<std::int64_t, std::vector<std::pair<int, std::size_t>>> parts_;
};

/// The last place of the largest coordinate that ClosestPoint may hold, in voxels.
double coordinateRounding(const TriangleMesh& mesh, double unit)
{
  double largest = 0.0;
  for (const Point3& p : mesh.points)
  {
    largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
  }
  return largest * static_cast<double>(std::numeric_limits<float>::epsilon()) / unit;
}

/// Adds the errors of one voxel after the other.
class ErrorSum
{
public:
  ErrorSum(const TriangleMesh& mesh, const DistanceField& field)
    : mesh_(mesh)
    , field_(field)
    , connectivity_(analyseConnectivity(mesh))
    , toCell_(mesh)
    , unit_(voxelSize(field.grid))
  {
    errors_.rounding = coordinateRounding(mesh, unit_);
  }

  void add(std::size_t voxel, const Hit& truth)
  {
    const Point3 x = voxelPoint(field_.grid, voxel);
    const std::int64_t site = field_.closestSite[voxel];
    const auto sites = static_cast<std::int64_t>(
      mesh_.triangles.size() + connectivity_.edges.size() + mesh_.points.size());
    const bool valid = site >= 0 && site < sites;
    const double siteExcess =
      valid ? distanceToSite(mesh_, connectivity_, site, x) - truth.distance : 0.0;
    const Point3 closest = this->closestPoint(voxel);
    const double distance = std::abs(static_cast<double>(field_.distance[voxel]));
    const double fromCell = toCell_(field_.closestCell[voxel], closest);
    const bool rightKind = valid &&
      field_.closestFeature[voxel] == static_cast<int>(kindOfSite(mesh_, connectivity_, site));
    const std::lock_guard<std::mutex> lock(mutex_);
    ++errors_.voxels;
    errors_.withoutSite += valid ? 0 : 1;
    errors_.wrongFeature += rightKind ? 0 : 1;
    errors_.site = std::max(errors_.site, siteExcess / unit_);
    errors_.pointLength =
      std::max(errors_.pointLength, std::abs(length(closest, x) - distance) / unit_);
    errors_.pointFromCell = std::max(errors_.pointFromCell, fromCell / unit_);
    this->addDistance(voxel, std::abs(distance - truth.distance) / unit_);
  }

  const FieldErrors& errors() const { return errors_; }

private:
  Point3 closestPoint(std::size_t voxel) const
  {
    const auto first = field_.closestPoint.begin() + static_cast<std::ptrdiff_t>(3 * voxel);
    Point3 point{};
    std::copy(first, first + 3, point.begin());
    return point;
  }

  void addDistance(std::size_t voxel, double error)
  {
    errors_.inexact += error <= kUsualTolerance ? 0 : 1;
    // NaN counts as the worst error.
    if (!(error <= errors_.distance))
    {
      errors_.distance = std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
      errors_.worst = voxel;
    }
  }

  const TriangleMesh& mesh_;
  const DistanceField& field_;
  MeshConnectivity connectivity_;
  CellDistance toCell_;
  double unit_;
  FieldErrors errors_;
  std::mutex mutex_;
};

std::vector<Hit> truthAt(const TriangleMesh& mesh, const Grid& grid, const Voxels& voxels)
{
  std::vector<Point3> queries;
  queries.reserve(voxels.size());
  for (const std::size_t voxel : voxels)
  {
    queries.push_back(voxelPoint(grid, voxel));
  }
  return closestOnMesh(mesh, queries);
}

FieldErrors fieldErrors(const TriangleMesh& mesh, const DistanceField& field, const Voxels& voxels,
  const std::vector<Hit>& truth)
{
  ErrorSum sum(mesh, field);
  parallelFor(voxels.size(), [&](std::size_t i) { sum.add(voxels[i], truth[i]); });
  return sum.errors();
}

void expectExact(const TriangleMesh& mesh, const DistanceField& field, const Voxels& voxels,
  const std::vector<Hit>& truth)
{
  const FieldErrors errors = fieldErrors(mesh, field, voxels, truth);
  const double pointTolerance = kTolerance + 4.0 * errors.rounding;
  const bool exact = errors.voxels > 0 && errors.withoutSite == 0 && errors.wrongFeature == 0 &&
    errors.distance <= kTolerance && errors.inexact * kRare <= errors.voxels &&
    errors.site <= kTolerance && errors.pointLength <= pointTolerance &&
    errors.pointFromCell <= pointTolerance;
  EXPECT_TRUE(exact) << errors.describe();
}

} // namespace

Voxels allVoxels(const Grid& grid)
{
  Voxels voxels(static_cast<std::size_t>(grid.pointCount()));
  std::iota(voxels.begin(), voxels.end(), std::size_t{ 0 });
  return voxels;
}

Voxels randomVoxels(const Grid& grid, std::size_t count, std::uint32_t seed)
{
  const auto all = static_cast<std::size_t>(grid.pointCount());
  if (all <= count)
  {
    return allVoxels(grid);
  }
  std::mt19937_64 random(seed);
  Voxels voxels(count);
  std::generate(voxels.begin(), voxels.end(), [&] { return random() % all; });
  return voxels;
}

Point3 voxelPoint(const Grid& grid, std::size_t voxel)
{
  const auto width = static_cast<std::size_t>(grid.dimensions[0]);
  const auto height = static_cast<std::size_t>(grid.dimensions[1]);
  return grid.point(static_cast<int>(voxel % width), static_cast<int>(voxel / width % height),
    static_cast<int>(voxel / width / height));
}

double voxelSize(const Grid& grid)
{
  return std::min({ grid.spacing[0], grid.spacing[1], grid.spacing[2] });
}

std::string FieldErrors::describe() const
{
  std::ostringstream text;
  text << voxels << " voxels: distance wrong by up to " << distance << " at voxel " << worst << ", "
       << inexact << " times by more than 1e-3; site " << site << ", point length " << pointLength
       << ", point from cell " << pointFromCell << ", without site " << withoutSite
       << ", wrong feature " << wrongFeature;
  return text.str();
}

FieldErrors fieldErrors(const TriangleMesh& mesh, const DistanceField& field, const Voxels& voxels)
{
  return fieldErrors(mesh, field, voxels, truthAt(mesh, field.grid, voxels));
}

void expectExact(const TriangleMesh& mesh, const DistanceField& field, const Voxels& voxels)
{
  expectExact(mesh, field, voxels, truthAt(mesh, field.grid, voxels));
}

std::vector<DistanceFieldOptions> allEngines(const DistanceFieldOptions& options)
{
  std::vector<DistanceFieldOptions> all;
  for (const Engine engine : { Engine::Device, Engine::Rasteriser, Engine::Processor })
  {
    all.push_back(options);
    all.back().engine = engine;
  }
  return all;
}

std::vector<DistanceFieldOptions> enginesFor(const Grid& grid, const DistanceFieldOptions& options)
{
  constexpr std::int64_t kMaxPoints = 1000000;
  std::vector<DistanceFieldOptions> engines = allEngines(options);
  if (grid.pointCount() > kMaxPoints && queryDevice().software)
  {
    engines.erase(engines.begin());
  }
  return engines;
}

void expectExactField(const TriangleMesh& mesh, const Grid& grid, const Voxels& voxels)
{
  const std::vector<Hit> truth = truthAt(mesh, grid, voxels);
  for (const DistanceFieldOptions& options : enginesFor(grid))
  {
    SCOPED_TRACE(options.engine);
    expectExact(mesh, computeDistanceField(mesh, grid, options), voxels, truth);
  }
}

void expectExactField(const TriangleMesh& mesh, const Grid& grid,
  const DistanceFieldOptions& options)
{
  for (const DistanceFieldOptions& each : enginesFor(grid, options))
  {
    SCOPED_TRACE(each.engine);
    expectExact(mesh, computeDistanceField(mesh, grid, each), allVoxels(grid));
  }
}

void computePart(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Extent& extent, DistanceField& field)
{
  const auto count = static_cast<std::size_t>(extent.pointCount());
  std::vector<float> distance(count);
  std::vector<std::int32_t> site(count);
  FieldArrays arrays;
  arrays.distance = distance.data();
  arrays.closestSite = site.data();
  computeDistanceField(mesh, connectivity, field.grid, extent, arrays);
  std::size_t source = 0;
  for (int k = extent.min[2]; k <= extent.max[2]; ++k)
  {
    for (int j = extent.min[1]; j <= extent.max[1]; ++j)
    {
      for (int i = extent.min[0]; i <= extent.max[0]; ++i, ++source)
      {
        const auto& n = field.grid.dimensions;
        const std::size_t target = i + static_cast<std::size_t>(n[0]) * (j + n[1] * k);
        field.distance[target] = distance[source];
        field.closestSite[target] = site[source];
      }
    }
  }
}

FieldDifference difference(const TriangleMesh& mesh, const DistanceField& a, const DistanceField& b)
{
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const double unit = voxelSize(a.grid);
  FieldDifference result;
  for (std::size_t i = 0; i < a.distance.size(); ++i)
  {
    const double gap =
      std::abs(static_cast<double>(a.distance[i]) - static_cast<double>(b.distance[i])) / unit;
    result.distance = std::max(result.distance, gap);
    if (a.closestSite[i] != b.closestSite[i])
    {
      const Point3 x = voxelPoint(a.grid, i);
      const double toA = distanceToSite(mesh, connectivity, a.closestSite[i], x);
      const double toB = distanceToSite(mesh, connectivity, b.closestSite[i], x);
      ++result.sites;
      result.untiedSites += std::abs(toA - toB) > kUsualTolerance * unit ? 1 : 0;
    }
  }
  return result;
}

} // namespace medial::test
