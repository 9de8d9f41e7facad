#include "medial/field_proximity.h"

#include "base/box.h"
#include "base/longest_axis.h"
#include "base/range_check.h"
#include "base/stopwatch.h"
#include "base/vectors.h"
#include "medial/error.h"
#include "medial/medial_solver.h"
#include "mesh/cell_check.h"
#include "proximity/decisive_extent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace medial
{
namespace
{

void requireUsable(int number, const TriangleMesh& mesh)
{
  try
  {
    requireCells(mesh);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      medial::requireUsable(i, mesh.points[i]);
    }
  }
  catch (const Error& error)
  {
    throw Error(error.code(), "mesh " + std::to_string(number) + ": " + error.what());
  }
}

Box boxOf(const TriangleMesh& mesh)
{
  const Bounds bounds = mesh.bounds();
  return { toVector(bounds.min), toVector(bounds.max) };
}

/// Returns a distance that the surfaces are not farther apart than: that of the points of A from
/// one of B, and so on to and fro.
double maxSeparation(const TriangleMesh& a, const TriangleMesh& b)
{
  double squared = std::numeric_limits<double>::infinity();
  const TriangleMesh* meshes[] = { &a, &b };
  glm::dvec3 from = toVector(b.points.front());
  for (int i = 0;; i = 1 - i)
  {
    const double before = squared;
    glm::dvec3 nearest = from;
    for (const Point3& point : meshes[i]->points)
    {
      const glm::dvec3 gap = toVector(point) - from;
      if (glm::dot(gap, gap) < squared)
      {
        squared = glm::dot(gap, gap);
        nearest = toVector(point);
      }
    }
    if (squared == before)
    {
      return std::sqrt(squared);
    }
    from = nearest;
  }
}

/// Returns the box of what is within a distance of both meshes' boxes.
Box regionOf(const TriangleMesh& a, const TriangleMesh& b, double reach)
{
  const Box boxA = boxOf(a);
  const Box boxB = boxOf(b);
  Box region;
  region.min = glm::max(boxA.min, boxB.min) - reach;
  region.max = glm::min(boxA.max, boxB.max) + reach;
  return region;
}

/// Returns a grid of cubic cells over a region, with at least two points along every axis.
Grid gridOver(const Box& region, int resolution)
{
  const glm::dvec3 size = region.size();
  const double longest = size[longestAxis(size)];
  // Boxes that touch at a point have some size, too.
  const double spacing =
    longest > 0.0 ? longest / (resolution - 1) : 1e-6 * std::max(1e-6, glm::length(region.max));
  Grid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.dimensions[axis] = std::clamp(static_cast<int>(std::ceil(size[axis] / spacing - 1e-9)) + 1,
      kMinResolution, kMaxDimension);
    grid.spacing[axis] = spacing;
    const double overhang = (grid.dimensions[axis] - 1) * spacing - size[axis];
    grid.origin[axis] = region.min[axis] - 0.5 * overhang;
  }
  return grid;
}

/// Grids with fewer points along their longest side are computed as a whole.
constexpr int kMinResolutionOfParts = 192;

/// Two meshes and their distances where they can be decisive.
class FieldPair
{
public:
  FieldPair(TriangleMesh a, TriangleMesh b)
    : solvers_{ MedialSolver(std::move(a)), MedialSolver(std::move(b)) }
  {
  }

  MedialSolver& solver(int mesh) { return solvers_[mesh]; }

  /// Compares the fields on a grid. Where signs are sure to change at the surfaces only, the field
  /// of a coarser grid says first which part of the grid it takes.
  /// @param separation whether it is wanted, too, if the meshes do not collide there.
  void compare(const FieldProximityOptions& options, bool separation, FieldProximity& result);

private:
  /// Whether the sign of a mesh's distances changes at its surface only.
  static bool hasSureSign(const MedialSolver& solver)
  {
    const TriangleMesh& mesh = solver.mesh();
    return mesh.triangles.empty() || solver.connectivity().closed();
  }

  void computeFields(const Grid& grid, const Extent& extent, const FieldProximityOptions& options);
  void compareOn(const Grid& grid, const Extent& extent, FieldProximity& result) const;

  MedialSolver solvers_[2];
  std::array<std::vector<float>, 2> distances_;
};

void FieldPair::compare(const FieldProximityOptions& options, bool separation,
  FieldProximity& result)
{
  const Grid& grid = result.grid;
  Extent extent = grid.wholeExtent();
  if (options.resolution >= kMinResolutionOfParts && hasSureSign(solvers_[0]) &&
    hasSureSign(solvers_[1]))
  {
    const Grid coarse = coarseGrid(grid);
    this->computeFields(coarse, coarse.wholeExtent(), options);
    extent = decisiveExtent(grid, distances_, separation);
  }
  if (!extent.empty())
  {
    this->computeFields(grid, extent, options);
    this->compareOn(grid, extent, result);
  }
}

void FieldPair::computeFields(const Grid& grid, const Extent& extent,
  const FieldProximityOptions& options)
{
  for (int i = 0; i < 2; ++i)
  {
    distances_[i].resize(static_cast<std::size_t>(extent.pointCount()));
    FieldArrays arrays;
    arrays.distance = distances_[i].data();
    DistanceFieldOptions fieldOptions;
    fieldOptions.engine = options.engine;
    fieldOptions.execution = options.execution;
    solvers_[i].computeField(grid, extent, arrays, fieldOptions);
  }
}

void FieldPair::compareOn(const Grid& grid, const Extent& extent, FieldProximity& result) const
{
  const double nearSurface = 0.5 * std::sqrt(3.0) * grid.spacing[0];
  double separation = std::numeric_limits<double>::infinity();
  std::int64_t inBoth = 0;
  std::size_t deepest = 0;
  for (std::size_t i = 0; i < distances_[0].size(); ++i)
  {
    const double a = distances_[0][i];
    const double b = distances_[1][i];
    if (a < 0.0 && b < 0.0)
    {
      ++inBoth;
      result.commonDepth = std::max(result.commonDepth, -a - b);
    }
    else if (a >= 0.0 && b >= 0.0)
    {
      separation = std::min(separation, a + b);
    }
    const double depth =
      std::max(std::abs(a) <= nearSurface ? -b : 0.0, std::abs(b) <= nearSurface ? -a : 0.0);
    if (depth > result.depth)
    {
      result.depth = depth;
      deepest = i;
    }
  }
  const glm::dvec3 spacing = toVector(grid.spacing);
  result.overlapVolume = static_cast<double>(inBoth) * spacing.x * spacing.y * spacing.z;
  result.collide = inBoth > 0;
  result.depth = result.collide ? result.depth : 0.0;
  result.separation = result.collide ? 0.0 : separation;
  const auto width = static_cast<std::size_t>(extent.size(0));
  const auto height = static_cast<std::size_t>(extent.size(1));
  result.deepestPoint = grid.point(extent.min[0] + static_cast<int>(deepest % width),
    extent.min[1] + static_cast<int>(deepest / width % height),
    extent.min[2] + static_cast<int>(deepest / width / height));
}

} // namespace

struct FieldProximitySolver::State
{
  FieldPair pair;
};

FieldProximitySolver::FieldProximitySolver(TriangleMesh a, TriangleMesh b)
{
  requireUsable(0, a);
  requireUsable(1, b);
  state_ = std::make_unique<State>(State{ FieldPair(std::move(a), std::move(b)) });
}

FieldProximitySolver::~FieldProximitySolver() = default;
FieldProximitySolver::FieldProximitySolver(FieldProximitySolver&& other) noexcept = default;
FieldProximitySolver& FieldProximitySolver::operator=(
  FieldProximitySolver&& other) noexcept = default;

void FieldProximitySolver::setPoints(int mesh, std::vector<Point3> points)
{
  if (mesh != 0 && mesh != 1)
  {
    throw Error(ErrorCode::InvalidInput, "there is no mesh " + std::to_string(mesh) + " of 2");
  }
  state_->pair.solver(mesh).setPoints(std::move(points));
}

FieldProximity FieldProximitySolver::compute(const FieldProximityOptions& options)
{
  if (options.resolution < kMinResolution || options.resolution > kMaxDimension)
  {
    throwOutside("resolution", options.resolution, closedRange(kMinResolution, kMaxDimension));
  }
  FieldProximity result;
  const Stopwatch stopwatch(result.seconds);
  const TriangleMesh& a = state_->pair.solver(0).mesh();
  const TriangleMesh& b = state_->pair.solver(1).mesh();
  const auto computeWithin = [&](double reach, bool separation)
  {
    result.grid = gridOver(regionOf(a, b, reach), options.resolution);
    state_->pair.compare(options, separation, result);
  };
  if (boxOf(a).overlaps(boxOf(b)))
  {
    computeWithin(0.0, false);
  }
  if (!result.collide)
  {
    computeWithin(maxSeparation(a, b), true); // where the closest points must be
  }
  return result;
}

} // namespace medial
