#include "field/engines/processor/tile_evaluator.h"

#include "base/simd.h"
#include "sites/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace medial
{
namespace
{

static_assert(TileField::kRow == kLanes);

/// Number of candidates to prefetch.
constexpr int kAhead = 3;

/// Sharper triangles also need the planes across the ends of their longest edge: beyond the acute
/// corner, rounding turns the space between the long edges into a strip.
constexpr double kNeedleSine = 0.05;

/// The function dot(normal, x) - offset over the grid points of a tile.
struct TileFunction
{
  float perX;
  float perY;
  float perZ;
  float first; ///< value at the tile's first point
};

/// A tile in progress.
struct Tile
{
  glm::dvec3 origin;
  glm::dvec3 step;
  int rows; ///< along y
  int firstSlice;
  int endSlice;
  float lastX; ///< index of the last point of a row
  TileField& field;

  MEDIAL_INLINE TileFunction function(const glm::dvec3& normal, double offset) const
  {
    return { static_cast<float>(normal.x * step.x), static_cast<float>(normal.y * step.y),
      static_cast<float>(normal.z * step.z),
      static_cast<float>(glm::dot(normal, origin) - offset) };
  }
};

/// Returns the value at the start of the row of grid points (j, k).
MEDIAL_INLINE float rowStart(const TileFunction& f, int j, int k)
{
  return f.first + f.perY * static_cast<float>(j) + f.perZ * static_cast<float>(k);
}

MEDIAL_INLINE Float8 onRow(const TileFunction& f, int j, int k)
{
  return ramp() * f.perX + rowStart(f, j, k);
}

/// Returns the smallest value on each row of slice k.
MEDIAL_INLINE Float8 minOfRows(const Tile& tile, const TileFunction& f, int k)
{
  const float atStart = f.first + f.perZ * static_cast<float>(k);
  return ramp() * f.perY + (atStart + std::min(0.0f, f.perX * tile.lastX));
}

template <typename T>
MEDIAL_INLINE T blended(Int8 mask, T yes, T no)
{
  return mask ? yes : no;
}

/// Stores the values that are smaller than all before.
MEDIAL_INLINE void offer(TileField& field, int row, Float8 squared, Float8 side, int site,
  Int8 allowed)
{
  const Float8 before = loaded(field.squared + row);
  const Int8 nearer = (squared < before) & allowed;
  store(blended(nearer, squared, before), field.squared + row);
  store(blended(nearer, side, loaded(field.side + row)), field.side + row);
  const Int8 sites = blended(nearer, Int8{} + site, loadedInts(field.site + row));
  std::memcpy(field.site + row, &sites, sizeof(sites));
}

/// Returns the rows of slice k that the bounds of a site meet, as bits.
template <typename Functions>
MEDIAL_INLINE unsigned rowsWithin(const Tile& tile, const Functions& bounds, int count, int k,
  float slack)
{
  Float8 worst = minOfRows(tile, bounds[0], k);
  for (int i = 1; i < count; ++i)
  {
    worst = max(worst, minOfRows(tile, bounds[i], k));
  }
  return bits(worst <= slack) & ((1u << tile.rows) - 1u);
}

/// @param height over the plane of the face; `sides` are <= 0 within its prism.
MEDIAL_INLINE std::int64_t addFace(const Tile& tile, int site, const TileFunction& height,
  const TileFunction* sides, int sideCount)
{
  std::int64_t rows = 0;
  for (int k = tile.firstSlice; k < tile.endSlice; ++k)
  {
    for (unsigned left = rowsWithin(tile, sides, sideCount, k, 0.0f); left != 0; left &= left - 1)
    {
      const int j = __builtin_ctz(left);
      Float8 worst = onRow(sides[0], j, k);
      for (int i = 1; i < sideCount; ++i)
      {
        worst = max(worst, onRow(sides[i], j, k));
      }
      const Float8 h = onRow(height, j, k);
      offer(tile.field, TileField::index(0, j, k), h * h, h, site, worst <= 0.0f);
      ++rows;
    }
  }
  return rows;
}

/// The vector from a point of the site to the grid points, by axis.
struct Offset
{
  Float8 x;
  float y, z; ///< at the tile's first point
  float stepY, stepZ;

  MEDIAL_INLINE Offset(const Tile& tile, const glm::dvec3& from)
    : x(ramp() * static_cast<float>(tile.step.x) + static_cast<float>(tile.origin.x - from.x))
    , y(static_cast<float>(tile.origin.y - from.y))
    , z(static_cast<float>(tile.origin.z - from.z))
    , stepY(static_cast<float>(tile.step.y))
    , stepZ(static_cast<float>(tile.step.z))
  {
  }

  /// Returns the squared length of the y and z components on row (j, k).
  MEDIAL_INLINE float squaredYZ(int j, int k) const
  {
    const float dy = y + stepY * static_cast<float>(j);
    const float dz = z + stepZ * static_cast<float>(k);
    return dy * dy + dz * dz;
  }
};

/// @param across two functions whose squares add up to the squared distance from the edge's line.
/// @param bounds <= 0 inside: those at the start and the end, then those of the edge's faces.
MEDIAL_INLINE std::int64_t addEdge(const Tile& tile, int site, const TileFunction (&across)[2],
  const TileFunction& side, const TileFunction* bounds, int boundCount, float slack)
{
  std::int64_t rows = 0;
  for (int k = tile.firstSlice; k < tile.endSlice; ++k)
  {
    for (unsigned left = rowsWithin(tile, bounds, boundCount, k, slack); left != 0;
         left &= left - 1)
    {
      const int j = __builtin_ctz(left);
      const Float8 u = onRow(across[0], j, k);
      const Float8 v = onRow(across[1], j, k);
      const Int8 projects = (onRow(bounds[0], j, k) <= 0.0f) & (onRow(bounds[1], j, k) <= 0.0f);
      offer(tile.field, TileField::index(0, j, k), u * u + v * v, onRow(side, j, k), site,
        projects);
      ++rows;
    }
  }
  return rows;
}

MEDIAL_INLINE std::int64_t addVertex(const Tile& tile, int site, const Offset& offset,
  const TileFunction& side)
{
  const Float8 squaredX = offset.x * offset.x;
  for (int k = tile.firstSlice; k < tile.endSlice; ++k)
  {
    for (int j = 0; j < tile.rows; ++j)
    {
      offer(tile.field, TileField::index(0, j, k), squaredX + offset.squaredYZ(j, k),
        onRow(side, j, k), site, Int8{} - 1);
    }
  }
  return static_cast<std::int64_t>(tile.endSlice - tile.firstSlice) * tile.rows;
}

/// Finds two unit vectors orthogonal to a third and to each other (Duff et al. 2017).
MEDIAL_INLINE void completeBasis(const glm::dvec3& n, glm::dvec3 (&across)[2])
{
  const double sign = std::copysign(1.0, n.z);
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  across[0] = { 1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x };
  across[1] = { b, sign + n.y * n.y * a, -n.y };
}

/// Evaluates a face.
/// @param normal the pseudonormal: the normal of the face, turned outwards.
MEDIAL_INLINE std::int64_t evaluateFace(const Tile& tile, const SiteSet& sites, int site,
  const glm::dvec3& normal, const FaceSides& sides)
{
  TileFunction bounds[5];
  for (int i = 0; i < sides.count; ++i)
  {
    bounds[i] = tile.function(glm::dvec3(sides.side[i]), sides.side[i].w);
  }
  const glm::dvec3& corner = sites.points()[sites.faces()[site][0]];
  const glm::dvec3& faceNormal = sites.faceNormal(site);
  const double turn = glm::dot(faceNormal, normal) < 0.0 ? -1.0 : 1.0;
  return addFace(tile, site, tile.function(turn * faceNormal, turn * glm::dot(faceNormal, corner)),
    bounds, sides.count);
}

/// Evaluates an edge, within its ends and as many of its other half-spaces as there is room for.
MEDIAL_INLINE std::int64_t evaluateEdge(const Tile& tile, const SiteSet& sites,
  const SiteBounds& siteBounds, int site, const glm::dvec3& normal, float slack)
{
  constexpr int kMaxBounds = 8;
  TileFunction bounds[kMaxBounds];
  const glm::ivec2& ends = sites.edges()[site - sites.firstEdge()];
  const glm::dvec3& p = sites.points()[ends[0]];
  const glm::dvec3& q = sites.points()[ends[1]];
  const double length = glm::distance(p, q);
  const glm::dvec3 u = (q - p) / length;
  const double start = glm::dot(u, p);
  bounds[0] = tile.function(-u, -start);
  bounds[1] = tile.function(u, start + length);
  int boundCount = 2;
  const HalfSpace* end = siteBounds.end(site);
  for (const HalfSpace* h = siteBounds.begin(site) + 2; h != end && boundCount < kMaxBounds; ++h)
  {
    bounds[boundCount++] = tile.function(glm::dvec3(*h), static_cast<double>(h->w));
  }
  glm::dvec3 across[2];
  completeBasis(u, across);
  const TileFunction distance[2] = { tile.function(across[0], glm::dot(across[0], p)),
    tile.function(across[1], glm::dot(across[1], p)) };
  return addEdge(tile, site, distance, tile.function(normal, glm::dot(normal, p)), bounds,
    boundCount, slack);
}

glm::dvec4 plane(const glm::dvec3& normal, const glm::dvec3& point)
{
  return { normal, glm::dot(normal, point) };
}

} // namespace

TileEvaluator::TileEvaluator(const SiteSet& sites, const SiteBounds& bounds,
  const std::vector<glm::vec4>& normals, const GridFrame& frame, float slack)
  : sites_(sites)
  , bounds_(bounds)
  , normals_(normals)
  , frame_(frame)
  , slack_(slack)
  , faceSides_(sites.faceCount())
{
}

FaceSides TileEvaluator::sidesOf(int face) const
{
  FaceSides result{};
  if (!sites_.active(face))
  {
    return result;
  }
  const glm::ivec3& corners = sites_.faces()[face];
  glm::dvec3 along[3];
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& a = sites_.points()[corners[i]];
    along[i] = glm::normalize(sites_.points()[corners[(i + 1) % 3]] - a);
    result.side[i] = plane(glm::normalize(glm::cross(along[i], sites_.faceNormal(face))), a);
  }
  const int longest = sites_.longestEdge(face);
  const glm::dvec3& u = along[longest];
  result.side[3] = plane(-u, sites_.points()[corners[longest]]);
  result.side[4] = plane(u, sites_.points()[corners[(longest + 1) % 3]]);
  const double sine = std::min(glm::length(glm::cross(u, along[(longest + 1) % 3])),
    glm::length(glm::cross(u, along[(longest + 2) % 3])));
  result.count = sine < kNeedleSine ? 5 : 3;
  return result;
}

glm::dvec3 TileEvaluator::displacement(int site, const glm::dvec3& x) const
{
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
    {
      const glm::dvec3& normal = sites_.faceNormal(site);
      return glm::dot(normal, sites_.points()[sites_.faces()[site][0]] - x) * normal;
    }
    case SiteKind::Edge:
    {
      const glm::ivec2& ends = sites_.edges()[site - sites_.firstEdge()];
      const glm::dvec3 toStart = sites_.points()[ends[0]] - x;
      const glm::dvec3 along = sites_.points()[ends[1]] - sites_.points()[ends[0]];
      return toStart - glm::dot(toStart, along) / glm::dot(along, along) * along;
    }
    case SiteKind::Vertex:
      break;
  }
  return sites_.points()[site - sites_.firstVertex()] - x;
}

void TileEvaluator::setSides(const Extent& tile, const SliceRange& slices, TileField& field) const
{
  for (int k = slices.begin; k < slices.end; ++k)
  {
    for (int j = 0; j < tile.size(1); ++j)
    {
      for (int i = 0; i < tile.size(0); ++i)
      {
        const int index = TileField::index(i, j, k);
        const int site = field.site[index];
        const glm::dvec3 x =
          frame_.sample(glm::dvec3(tile.min[0] + i, tile.min[1] + j, tile.min[2] + k));
        field.side[index] =
          static_cast<float>(-glm::dot(glm::dvec3(normals_[site]), this->displacement(site, x)));
      }
    }
  }
}

std::int64_t TileEvaluator::evaluate(const Extent& extent, const int* candidates, std::size_t count,
  const SliceRange& slices, TileField& field) const
{
  const auto setSides = [this](int face, FaceSides* table) { table[face] = this->sidesOf(face); };
  for (std::size_t i = 0; i < count; ++i)
  {
    bounds_.prepare(candidates[i]);
    if (candidates[i] < sites_.faceCount())
    {
      faceSides_.prepare(candidates[i], setSides);
    }
  }
  return this->evaluatePrepared(extent, candidates, count, slices, field);
}

MEDIAL_VECTORISED std::int64_t TileEvaluator::evaluatePrepared(const Extent& extent,
  const int* candidates, std::size_t count, const SliceRange& slices, TileField& field) const
{
  Tile tile{ frame_.sample({ extent.min[0], extent.min[1], extent.min[2] }), frame_.step,
    extent.size(1), slices.begin, slices.end, static_cast<float>(extent.size(0) - 1), field };
  std::fill(std::begin(field.squared), std::end(field.squared), std::numeric_limits<float>::max());
  std::fill(std::begin(field.site), std::end(field.site), -1);
  std::int64_t rows = 0;
  for (const int* candidate = candidates; candidate != candidates + count; ++candidate)
  {
    const int site = *candidate;
    if (candidate + kAhead < candidates + count && candidate[kAhead] < sites_.faceCount())
    {
      __builtin_prefetch(&faceSides_[candidate[kAhead]]);
      __builtin_prefetch(&sites_.faceNormal(candidate[kAhead]));
    }
    const glm::dvec3 normal = normals_.empty() ? glm::dvec3(0.0) : glm::dvec3(normals_[site]);
    switch (sites_.kind(site))
    {
      case SiteKind::Face:
        rows += evaluateFace(tile, sites_, site, normal, faceSides_[site]);
        break;
      case SiteKind::Edge:
        rows += evaluateEdge(tile, sites_, bounds_, site, normal, slack_);
        break;
      case SiteKind::Vertex:
      default:
      {
        const glm::dvec3& p = sites_.points()[site - sites_.firstVertex()];
        rows += addVertex(tile, site, Offset(tile, p), tile.function(normal, glm::dot(normal, p)));
        break;
      }
    }
  }
  return rows * extent.size(0);
}

} // namespace medial
