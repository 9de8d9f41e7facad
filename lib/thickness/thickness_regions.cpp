#include "medial/thickness_regions.h"

#include "base/checkpoint.h"
#include "base/disjoint_sets.h"
#include "base/range_check.h"
#include "base/sorted_set.h"
#include "medial/error.h"
#include "sign/sign_choice.h"
#include "thickness/region_checks.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace medial
{
namespace
{

glm::dvec3 positionOf(const TriangleMesh& mesh, int point)
{
  const Point3& x = mesh.points[point];
  return { x[0], x[1], x[2] };
}

/// Collects the triangles of one region.
class Collector
{
public:
  Collector(const TriangleMesh& mesh, const Thickness& thickness, bool thin)
    : mesh_(mesh)
    , thickness_(thickness)
  {
    region_.thin = thin;
  }

  void add(int triangle)
  {
    const std::array<int, 3>& corners = mesh_.triangles[triangle];
    const glm::dvec3 a = positionOf(mesh_, corners[0]);
    const glm::dvec3 b = positionOf(mesh_, corners[1]);
    const glm::dvec3 c = positionOf(mesh_, corners[2]);
    region_.area += 0.5 * glm::length(glm::cross(b - a, c - a));
    this->consider(thickness_.triangleValues[triangle], (a + b + c) / 3.0);
    for (const int corner : corners)
    {
      const bool counts = !region_.thin || thickness_.atEdge[corner] == 0;
      if (counts && !std::isnan(thickness_.values[corner]))
      {
        this->consider(thickness_.values[corner], positionOf(mesh_, corner));
      }
    }
    region_.triangles.push_back(triangle);
    region_.cells.push_back(mesh_.triangleCells[triangle]);
  }

  ThicknessRegion finish()
  {
    makeSet(region_.cells);
    return std::move(region_);
  }

private:
  void consider(float found, const glm::dvec3& place)
  {
    const auto value = static_cast<double>(found);
    const bool better = region_.thin ? value < region_.value : value > region_.value;
    if (first_ || better)
    {
      region_.value = value;
      region_.place = { place.x, place.y, place.z };
      first_ = false;
    }
  }

  const TriangleMesh& mesh_;
  const Thickness& thickness_;
  ThicknessRegion region_;
  bool first_ = true;
};

/// Joins triangles that share a point and are beyond the same limit.
void joinNeighbours(const TriangleMesh& mesh, const std::vector<Beyond>& beyond, DisjointSets& sets)
{
  constexpr int kNone = -1;
  std::vector<int> thin(mesh.points.size(), kNone); // of each point one triangle
  std::vector<int> thick(mesh.points.size(), kNone);
  for (std::size_t i = 0; i < beyond.size(); ++i)
  {
    if (beyond[i] == Beyond::Nothing)
    {
      continue;
    }
    std::vector<int>& triangleAt = beyond[i] == Beyond::Min ? thin : thick;
    for (const int corner : mesh.triangles[i])
    {
      if (triangleAt[corner] != kNone)
      {
        sets.join(triangleAt[corner], static_cast<std::int64_t>(i));
      }
      triangleAt[corner] = static_cast<int>(i);
    }
  }
}

} // namespace

void checkThicknessLimits(const ThicknessLimits& limits)
{
  const auto check = [](const std::optional<double>& limit, const char* name)
  {
    if (limit && !(*limit > 0.0 && std::isfinite(*limit)))
    {
      throwOutside(name, *limit, "(0, infinity)");
    }
  };
  check(limits.min, "minimum thickness");
  check(limits.max, "maximum thickness");
  if (!limits.min && !limits.max)
  {
    throw Error(ErrorCode::InvalidInput, "there is neither a minimum nor a maximum thickness");
  }
  if (limits.min && limits.max && *limits.min >= *limits.max)
  {
    throw Error(ErrorCode::InvalidInput,
      "minimum thickness " + numberText(*limits.min) + " is not below maximum thickness " +
        numberText(*limits.max));
  }
}

void requireInside(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const Execution& execution)
{
  if (connectivity.closed())
  {
    return;
  }
  const Run run(execution);
  const Checkpoint checkpoint(run, 0.0, "thickness");
  run.onThreads(
    [&]
    {
      const Grid grid = gridForInside(mesh.bounds());
      SurfaceOrienter orienter;
      const SignChoice sign(SignMethod::Auto, mesh, connectivity, grid, GridFrame(grid), orienter,
        checkpoint);
      requireSign(sign.report());
    });
}

std::vector<ThicknessRegion> findThicknessRegions(const TriangleMesh& mesh,
  const Thickness& thickness, const ThicknessLimits& limits)
{
  checkThicknessLimits(limits);
  requireValuesOf(mesh, thickness);
  const std::size_t triangles = mesh.triangles.size();
  std::vector<Beyond> beyond(triangles);
  for (std::size_t i = 0; i < triangles; ++i)
  {
    beyond[i] = beyondOf(thickness.triangleValues[i], thickness.triangleAtEdge[i] != 0, limits);
  }
  DisjointSets sets(triangles);
  joinNeighbours(mesh, beyond, sets);
  std::map<std::int64_t, Collector> collectors;
  for (std::size_t i = 0; i < triangles; ++i)
  {
    if (beyond[i] != Beyond::Nothing)
    {
      const auto id = static_cast<std::int64_t>(i);
      collectors.try_emplace(sets.find(id), mesh, thickness, beyond[i] == Beyond::Min)
        .first->second.add(static_cast<int>(i));
    }
  }
  std::vector<ThicknessRegion> regions;
  for (auto& [id, collector] : collectors)
  {
    regions.push_back(collector.finish());
  }
  std::stable_sort(regions.begin(), regions.end(),
    [](const ThicknessRegion& a, const ThicknessRegion& b)
    { return a.thin != b.thin ? a.thin : (a.thin ? a.value < b.value : a.value > b.value); });
  return regions;
}

} // namespace medial
