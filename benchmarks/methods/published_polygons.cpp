#include "methods/published_polygons.h"

#include "methods/slice_polygon.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace medial::benchmark
{
namespace
{

constexpr std::size_t kBoundsPerChunk = 4096;

// The paper does not say how it closes cracks between polygons that are cut independently. Here
// polygons grow by the rounding of rasterisers, in pixels, and by that of single precision.
constexpr float kSnapDilation = 0.008f;
constexpr float kPrecisionDilation = 0.0005f;

/// Cuts polygons out of one slice.
class SliceCutter
{
public:
  SliceCutter(const SiteSet& sites, const PublishedBounds& bounds, const GridFrame& frame,
    const AtlasLayout& atlas, int slice, int slot, PolygonChunk& chunk)
    : sites_(sites)
    , bounds_(bounds)
    , frame_(frame)
    , sliceSize_(atlas.sliceSize)
    , slice_(slice)
    , shift_(glm::vec2(atlas.slotOrigin(slot)) + 0.5f)
    , chunk_(chunk)
  {
  }

  /// @param reach no distance on the slice is larger.
  void add(const SiteBound& bound, double reach)
  {
    if (!this->findReached(sites_.boundingBall(bound.site), reach))
    {
      return;
    }
    SlicePolygon polygon(glm::vec2(high_ - low_));
    for (int i = bound.begin; i < bound.end && !polygon.empty(); ++i)
    {
      const Affine side = this->onSlice(bounds_.halfSpaces[i]);
      const float dilation = kPrecisionDilation +
        (i < bound.firstDilated ? 0.0f : kSnapDilation * std::hypot(side.a, side.b));
      polygon.clip(side, sites_.kind(bound.site) == SiteKind::Face ? 0.0f : dilation);
    }
    if (polygon.empty())
    {
      return;
    }
    polygon.snap();
    if (!polygon.empty() && polygon.coversGridPoint())
    {
      this->emit(polygon, bound.site);
    }
  }

private:
  /// The rectangle of grid points that are no farther from the sphere; false if it is empty.
  bool findReached(const glm::vec4& sphere, double reach)
  {
    const glm::dvec3 centre(sphere);
    const double radius = reach + static_cast<double>(sphere.w);
    const glm::dvec3 low = glm::ceil((centre - radius - frame_.first) / frame_.step);
    const glm::dvec3 high = glm::floor((centre + radius - frame_.first) / frame_.step);
    low_ = glm::max(glm::ivec2(low), glm::ivec2(0));
    high_ = glm::min(glm::ivec2(high), sliceSize_ - 1);
    return low.z <= slice_ && slice_ <= high.z && low_.x <= high_.x && low_.y <= high_.y;
  }

  Affine onSlice(const HalfSpace& halfSpace) const
  {
    const glm::dvec3 normal(halfSpace);
    const glm::dvec3 first = frame_.sample({ low_.x, low_.y, slice_ });
    const glm::vec2 gradient(normal * frame_.step);
    return { gradient.x, gradient.y,
      static_cast<float>(glm::dot(normal, first) - static_cast<double>(halfSpace.w)) };
  }

  /// Affine in x: the paper's linear factors.
  glm::dvec3 distanceVector(int site, const glm::dvec3& x) const
  {
    switch (sites_.kind(site))
    {
      case SiteKind::Face:
      {
        const glm::dvec3& normal = sites_.faceNormal(site);
        return normal * glm::dot(normal, sites_.points()[sites_.faces()[site].x] - x);
      }
      case SiteKind::Edge:
      {
        const glm::ivec2& ends = sites_.edges()[site - sites_.firstEdge()];
        const glm::dvec3& p = sites_.points()[ends[0]];
        const glm::dvec3 along = glm::normalize(sites_.points()[ends[1]] - p);
        return (p - x) - along * glm::dot(along, p - x);
      }
      case SiteKind::Vertex:
        break;
    }
    return sites_.points()[site - sites_.firstVertex()] - x;
  }

  void emit(const SlicePolygon& polygon, int site)
  {
    const auto base = static_cast<std::uint32_t>(chunk_.vertices.size());
    const int start = polygon.fanStart();
    for (int i = 0; i < polygon.size(); ++i)
    {
      const glm::vec2& corner = polygon.corner(start + i);
      const glm::dvec3 x = frame_.sample(
        { corner.x + static_cast<float>(low_.x), corner.y + static_cast<float>(low_.y), slice_ });
      chunk_.vertices.push_back(
        { corner + glm::vec2(low_) + shift_, glm::vec3(this->distanceVector(site, x)), site });
    }
    const auto corners = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t i = 2; i < corners; ++i)
    {
      chunk_.indices.insert(chunk_.indices.end(), { base, base + i - 1, base + i });
    }
    ++chunk_.polygons;
    chunk_.area += polygon.area();
  }

  const SiteSet& sites_;
  const PublishedBounds& bounds_;
  const GridFrame& frame_;
  glm::ivec2 sliceSize_;
  int slice_;
  glm::vec2 shift_;
  PolygonChunk& chunk_;

  glm::ivec2 low_{ 0 }; ///< grid points that the current site can reach
  glm::ivec2 high_{ 0 };
};

} // namespace

std::vector<PolygonChunk> publishedPolygons(const SiteSet& sites, const PublishedBounds& bounds,
  const GridFrame& frame, const AtlasLayout& atlas, const SliceBatch& batch)
{
  const std::size_t perSlice = (bounds.sites.size() + kBoundsPerChunk - 1) / kBoundsPerChunk;
  std::vector<PolygonChunk> chunks(perSlice * batch.reach.size());
  tbb::parallel_for(std::size_t{ 0 }, chunks.size(),
    [&](std::size_t index)
    {
      const int offset = static_cast<int>(index / perSlice);
      SliceCutter cutter(sites, bounds, frame, atlas, batch.first + offset, 1 + offset,
        chunks[index]);
      const std::size_t begin = index % perSlice * kBoundsPerChunk;
      const std::size_t end = std::min(begin + kBoundsPerChunk, bounds.sites.size());
      for (std::size_t i = begin; i < end; ++i)
      {
        cutter.add(bounds.sites[i], batch.reach[offset]);
      }
    });
  return chunks;
}

} // namespace medial::benchmark
