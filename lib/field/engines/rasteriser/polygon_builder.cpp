#include "field/engines/rasteriser/polygon_builder.h"

#include "field/engines/rasteriser/site_rectangles.h"
#include "field/engines/rasteriser/slice_polygon.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace medial
{
namespace
{

/// Bounds are dilated, since neighbouring polygons are cut independently. One margin is how far
/// snapping to 1/256 pixel can move two edges, in pixels of the slice; the other is the error of
/// single precision, in local units. Only harmless bounds are dilated: beyond the edges of a face
/// and the ends of an edge, distances would come out too small.
constexpr float kSnapDilation = 0.008f;
constexpr float kPrecisionDilation = 0.0005f;

constexpr std::size_t kRectanglesPerChunk = 1024;

/// The function dot(normal, x) - offset over the grid, split by axis so that slices are cheap to
/// reach.
struct GridFunction
{
  float a;
  float b;
  float perSlice;
  float c; ///< value at the local origin

  Affine onSlice(int slice) const { return { a, b, c + perSlice * static_cast<float>(slice) }; }
};

/// Cuts the polygons of one site after another and appends them to a chunk.
class SiteClipper
{
public:
  SiteClipper(const SiteSet& sites, const SiteBounds& bounds, const GridFrame& frame,
    const Extent& slab, const AtlasLayout& atlas, PolygonChunk& chunk)
    : sites_(sites)
    , bounds_(bounds)
    , frame_(frame)
    , slab_(slab)
    , atlas_(atlas)
    , chunk_(chunk)
  {
  }

  void add(const SiteRectangle& rectangle)
  {
    rectangle_ = rectangle;
    corner_ = frame_.sample({ rectangle.low.x, rectangle.low.y, rectangle.low.z });
    if (!this->collectSides())
    {
      return;
    }
    this->setDistance();
    for (int slice = 0; slice <= rectangle.high.z - rectangle.low.z; ++slice)
    {
      this->addSlice(slice);
    }
  }

private:
  struct Side
  {
    GridFunction function;
    float limit;
  };

  GridFunction gridFunction(const glm::dvec3& normal, double offset) const
  {
    const glm::vec3 gradient(normal * frame_.step);
    return { gradient.x, gradient.y, gradient.z,
      static_cast<float>(glm::dot(normal, corner_) - offset) };
  }

  /// Returns the first half-space of the site from which on dilation does no harm; see SiteBounds
  /// for their order.
  std::ptrdiff_t firstHarmlessSide() const
  {
    switch (sites_.kind(rectangle_.site))
    {
      case SiteKind::Face:
        return bounds_.end(rectangle_.site) - bounds_.begin(rectangle_.site);
      case SiteKind::Edge:
        return 2;
      case SiteKind::Vertex:
        break;
    }
    return 0;
  }

  /// Collects the half-spaces that cut the box of the rectangle; false if the box lies entirely
  /// outside one.
  bool collectSides()
  {
    sides_.clear();
    const std::ptrdiff_t firstHarmless = this->firstHarmlessSide();
    const glm::vec3 size(rectangle_.high - rectangle_.low);
    const HalfSpace* end = bounds_.end(rectangle_.site);
    for (const HalfSpace* h = bounds_.begin(rectangle_.site); h != end; ++h)
    {
      const GridFunction f = this->gridFunction(glm::dvec3(*h), static_cast<double>(h->w));
      const bool harmless = h - bounds_.begin(rectangle_.site) >= firstHarmless;
      const float limit =
        kPrecisionDilation + (harmless ? kSnapDilation * std::sqrt(f.a * f.a + f.b * f.b) : 0.0f);
      // The rectangle extends half a pixel beyond its grid points.
      const glm::vec3 reach(f.a * size.x, f.b * size.y, f.perSlice * size.z);
      const float margin = 0.5f * (std::abs(f.a) + std::abs(f.b));
      const float min =
        f.c + std::min(reach.x, 0.0f) + std::min(reach.y, 0.0f) + std::min(reach.z, 0.0f) - margin;
      const float max =
        f.c + std::max(reach.x, 0.0f) + std::max(reach.y, 0.0f) + std::max(reach.z, 0.0f) + margin;
      if (min > limit)
      {
        return false;
      }
      if (max > limit)
      {
        sides_.push_back({ f, limit });
      }
    }
    return true;
  }

  /// Sets the distance vector as affine functions (linear factorisation, section 3.1 of the paper):
  /// one along the normal of a face, two across an edge, three for a vertex.
  void setDistance()
  {
    const int site = rectangle_.site;
    distance_.fill({ 0.0f, 0.0f, 0.0f, 0.0f });
    switch (sites_.kind(site))
    {
      case SiteKind::Face:
      {
        const glm::dvec3& normal = sites_.faceNormal(site);
        const glm::dvec3& point = sites_.points()[sites_.faces()[site][0]];
        distance_[0] = this->gridFunction(normal, glm::dot(normal, point));
        return;
      }
      case SiteKind::Edge:
      {
        const glm::ivec2& ends = sites_.edges()[site - sites_.firstEdge()];
        const glm::dvec3& p = sites_.points()[ends[0]];
        const glm::dvec3 along = glm::normalize(sites_.points()[ends[1]] - p);
        const glm::dvec3 other =
          std::abs(along.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
        const glm::dvec3 e1 = glm::normalize(glm::cross(along, other));
        const glm::dvec3 e2 = glm::cross(along, e1);
        distance_[0] = this->gridFunction(e1, glm::dot(e1, p));
        distance_[1] = this->gridFunction(e2, glm::dot(e2, p));
        return;
      }
      case SiteKind::Vertex:
        break;
    }
    const glm::dvec3& p = sites_.points()[site - sites_.firstVertex()];
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 unit(0.0);
      unit[axis] = 1.0;
      distance_[axis] = this->gridFunction(unit, p[axis]);
    }
  }

  void addSlice(int slice)
  {
    SlicePolygon polygon(glm::vec2(rectangle_.high - rectangle_.low));
    for (const Side& side : sides_)
    {
      polygon.clip(side.function.onSlice(slice), side.limit);
      if (polygon.empty())
      {
        return;
      }
    }
    polygon.snap();
    if (!polygon.empty() && polygon.coversGridPoint())
    {
      this->emit(polygon, slice);
    }
  }

  void emit(const SlicePolygon& polygon, int slice)
  {
    const int slot = 1 + rectangle_.low.z + slice - slab_.min[2];
    const glm::ivec2 first(rectangle_.low.x - slab_.min[0], rectangle_.low.y - slab_.min[1]);
    const glm::vec2 shift = glm::vec2(atlas_.slotOrigin(slot) + first) + 0.5f;
    const auto base = static_cast<std::uint32_t>(chunk_.vertices.size());
    const Affine d[3] = { distance_[0].onSlice(slice), distance_[1].onSlice(slice),
      distance_[2].onSlice(slice) };
    const int start = polygon.fanStart();
    for (int i = 0; i < polygon.size(); ++i)
    {
      const glm::vec2& p = polygon.corner(start + i);
      chunk_.vertices.push_back({ p + shift, { d[0](p), d[1](p), d[2](p) }, rectangle_.site });
    }
    for (int i = 2; i < polygon.size(); ++i)
    {
      chunk_.indices.insert(chunk_.indices.end(),
        { base, base + static_cast<std::uint32_t>(i) - 1, base + static_cast<std::uint32_t>(i) });
    }
    ++chunk_.polygons;
    chunk_.area += polygon.area();
  }

  const SiteSet& sites_;
  const SiteBounds& bounds_;
  const GridFrame& frame_;
  const Extent& slab_;
  const AtlasLayout& atlas_;
  PolygonChunk& chunk_;

  SiteRectangle rectangle_{};
  glm::dvec3 corner_{ 0.0 }; ///< first grid point of the rectangle, local coordinates
  std::vector<Side> sides_;
  std::array<GridFunction, 3> distance_{};
};

} // namespace

std::vector<PolygonChunk> buildPolygons(const SiteSet& sites, const SiteBounds& bounds,
  const GridFrame& frame, const std::vector<CandidateTiles>& tiles, const Extent& slab,
  const AtlasLayout& atlas)
{
  const std::vector<SiteRectangle> rectangles = siteRectangles(tiles, slab, sites.size());
  const std::size_t count = (rectangles.size() + kRectanglesPerChunk - 1) / kRectanglesPerChunk;
  std::vector<PolygonChunk> chunks(count);
  tbb::parallel_for(std::size_t{ 0 }, count,
    [&](std::size_t index)
    {
      SiteClipper clipper(sites, bounds, frame, slab, atlas, chunks[index]);
      const std::size_t end = std::min(rectangles.size(), (index + 1) * kRectanglesPerChunk);
      for (std::size_t i = index * kRectanglesPerChunk; i < end; ++i)
      {
        clipper.add(rectangles[i]);
      }
    });
  return chunks;
}

} // namespace medial
