#pragma once

#include "field/engines/rasteriser/atlas_layout.h"
#include "field/engines/rasteriser/polygon_drawing.h"
#include "field/engines/rasteriser/site_rectangles.h"
#include "gl/gl_objects.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// Draws the polygons of a slab and turns the winners of the depth test into exact distances. The
/// next slab reuses its textures. Lives on the GPU thread.
class SlabRenderer
{
public:
  /// @throws Error GpuLimit or OutOfMemory.
  SlabRenderer(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
    const AtlasLayout& atlas);

  /// Moves the mesh to positions; only these are uploaded. To be called before anything is drawn.
  /// @param mesh of the same connectivity.
  /// @param normals pseudonormals() of all sites, reversed if the surface faces inwards; empty if
  ///   they do not give the sign.
  void move(const TriangleMesh& mesh, const std::vector<glm::vec4>& normals,
    const GridFrame& frame);

  /// Keeps the last slice of the previous slab in slot 0. To be called before draw().
  void carryLastSlice(int previousSlices);

  /// Culls for a slab; rectangles() lists what is left.
  void cull(const Extent& slab) { rectangles_.begin(*frame_, slab); }
  SiteRectangles& rectangles() { return rectangles_; }

  /// Finds the closest sites of a slab.
  /// @param source lists sites ascending on each slice, so that ties go to the lowest id.
  /// @param slab its slice slab.min[2] goes to slot 1 of the atlas.
  void draw(RectangleSource& source, const Extent& slab);

  /// Computes exact distances from the closest sites. Returns the number of grid points that no
  /// polygon covered.
  /// @param slab its slice slab.min[2] is in slot 1.
  std::uint32_t resolve(const Extent& slab);

  /// Reads slots [1, slices] of the resolved textures, slice by slice, x fastest. While a pixel
  /// buffer is bound, destinations are offsets into it.
  void readSites(int slices, std::int32_t* sites) const;
  void readDisplacements(int slices, glm::vec4* displacements) const;
  /// Overwrites resolved grid points of a row.
  /// @param point the first of them.
  /// @param displacements, sites one for each.
  void write(const glm::ivec2& point, int slot, const std::vector<glm::vec4>& displacements,
    const std::vector<std::int32_t>& sites);

  const AtlasLayout& atlas() const { return atlas_; }
  /// As PolygonDrawing::fragments().
  std::int64_t fragments() const { return polygons_ ? polygons_->fragments() : 0; }
  /// RGBA32F atlas: vector to the closest point and signed distance, local units.
  GLuint displacements() const { return displacements_.id(); }
  /// R32I atlas of the resolved site ids.
  GLuint sites() const { return sites_.id(); }

private:
  void createDrawTarget();

  AtlasLayout atlas_;
  Kernels kernels_;
  DeviceMesh mesh_;
  SiteRectangles rectangles_;
  std::optional<GridFrame> frame_; ///< of the positions
  bool hasNormals_ = false;
  float depthScale_ = 0.0f;
  std::optional<PolygonDrawing> polygons_;

  gl::Buffer normals_, holes_;
  gl::VertexArray noVertices_;
  gl::Texture winners_, depth_, displacements_, sites_;
  gl::Framebuffer drawTarget_, resolveTarget_;
};

} // namespace medial
