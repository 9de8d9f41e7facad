#pragma once

#include "field/engines/rasteriser/atlas_layout.h"
#include "field/engines/rasteriser/atlas_texture.h"
#include "gl/gl_objects.h"
#include "medial/mesh_connectivity.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// What the two methods that draw distance functions slice by slice have in common. All of it is in
// this header, since each method is a library of its own.
namespace medial::benchmark
{

/// Depth of a fragment per local unit of distance: a power of two that keeps depths below 1.
inline float depthPerUnit(const SiteSet& sites, const GridFrame& frame)
{
  double farthest = 0.0;
  for (const glm::dvec3& point : sites.points())
  {
    farthest = std::max(farthest, glm::length(point));
  }
  // Both ends of a distance lie within these balls around the local origin; tessellated functions
  // reach a little beyond the grid.
  const double longest = 2.0 * (farthest + glm::length(frame.first) + 1.0);
  return static_cast<float>(std::exp2(-std::ceil(std::log2(longest))));
}

/// For every site a triangle that holds it, -1 where there is none.
inline std::vector<int> triangleOfSites(const SiteSet& sites, const MeshConnectivity& connectivity)
{
  std::vector<int> triangles(sites.size(), -1);
  for (int face = 0; face < sites.faceCount(); ++face)
  {
    triangles[face] = face;
  }
  for (int edge = 0; edge < sites.edgeCount(); ++edge)
  {
    if (connectivity.edgeTriangles.size(edge) == 0)
    {
      continue;
    }
    const int triangle = *connectivity.edgeTriangles.begin(edge);
    triangles[sites.firstEdge() + edge] = triangle;
    for (const int point : connectivity.edges[edge])
    {
      triangles[sites.firstVertex() + point] = triangle;
    }
  }
  return triangles;
}

/// Slices of closest sites and their depths in GPU textures. For use on the GPU thread.
class SliceTarget
{
public:
  explicit SliceTarget(const AtlasLayout& atlas)
    : atlas_(atlas)
    , sites_(gl::createTexture2D(GL_R32I, atlas.size().x, atlas.size().y))
    , depths_(gl::createTexture2D(GL_DEPTH_COMPONENT32F, atlas.size().x, atlas.size().y))
    , framebuffer_(gl::createFramebuffer({ sites_.id() }, depths_.id()))
  {
  }

  const AtlasLayout& atlas() const { return atlas_; }

  /// Makes it the target of drawing, empty, with the depth test on.
  void begin() const
  {
    constexpr GLint kNoSite[4] = { -1, -1, -1, -1 };
    constexpr GLfloat kFar = 1.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, atlas_.size().x, atlas_.size().y);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glClearBufferiv(GL_COLOR, 0, kNoSite);
    glClearBufferfv(GL_DEPTH, 0, &kFar);
  }

  /// Waits until drawing is done, so that its time counts in its own phase.
  void finish() const
  {
    glDisable(GL_DEPTH_TEST);
    gl::checkGl("drawing distance functions");
    glFinish();
  }

  /// Reads slots as sites and depths, x fastest.
  void read(int firstSlot, int slots, std::int32_t* sites, float* depths) const
  {
    readSlots(sites_.id(), atlas_, firstSlot, slots, GL_RED_INTEGER, GL_INT, sizeof(*sites), sites);
    readSlots(depths_.id(), atlas_, firstSlot, slots, GL_DEPTH_COMPONENT, GL_FLOAT, sizeof(*depths),
      depths);
  }

private:
  AtlasLayout atlas_;
  gl::Texture sites_, depths_;
  gl::Framebuffer framebuffer_;
};

/// Makes triangles and world distances, in place, of sites and depths as SliceTarget::read() gives.
class SliceReader
{
public:
  SliceReader(const SiteSet& sites, const MeshConnectivity& connectivity, const GridFrame& frame)
    : triangles_(triangleOfSites(sites, connectivity))
    , unitPerDepth_(static_cast<float>(frame.unit) / depthPerUnit(sites, frame))
  {
  }

  void convert(std::int32_t* sites, float* depths, std::size_t count) const
  {
    constexpr std::size_t kPointsPerTask = 1 << 16;
    const auto convertRange = [&](const tbb::blocked_range<std::size_t>& range)
    {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
      {
        const bool covered = sites[i] >= 0;
        depths[i] = covered ? depths[i] * unitPerDepth_ : std::numeric_limits<float>::infinity();
        sites[i] = covered ? triangles_[sites[i]] : -1;
      }
    };
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kPointsPerTask), convertRange);
  }

private:
  std::vector<int> triangles_;
  float unitPerDepth_;
};

} // namespace medial::benchmark
