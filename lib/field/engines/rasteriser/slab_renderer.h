#pragma once

#include "field/engines/rasteriser/atlas_layout.h"
#include "field/engines/rasteriser/polygon_builder.h"
#include "field/field_sign.h"
#include "gl/gl_objects.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// Draws the polygons of a slab and turns the winners of the depth test into exact distances. The
/// next slab reuses its textures. Lives on the GPU thread.
class SlabRenderer
{
public:
  /// @param normals pseudonormals(), reversed if the surface faces inwards.
  SlabRenderer(const SiteSet& sites, const std::vector<glm::vec4>& normals, const GridFrame& frame,
    const AtlasLayout& atlas, FieldSign sign);

  /// Moves the mesh to other positions; only these are uploaded.
  void move(const SiteSet& sites, const std::vector<glm::vec4>& normals, const GridFrame& frame,
    FieldSign sign);

  /// Keeps the last slice of the previous slab in slot 0. To be called before draw().
  void carryLastSlice(int previousSlices);

  /// Finds the closest sites of slots [1, slices] of the atlas.
  void draw(const std::vector<PolygonChunk>& chunks);

  /// Computes exact distances from the closest sites. Returns the number of grid points that no
  /// polygon covered.
  /// @param slab its slice slab.min[2] is in slot 1.
  std::uint32_t resolve(const Extent& slab);

  /// Reads slots [1, slices] of the resolved textures, slice by slice, x fastest. While a pixel
  /// buffer is bound, destinations are offsets into it.
  void readSites(int slices, std::int32_t* sites) const;
  void readDisplacements(int slices, glm::vec4* displacements) const;
  /// Overwrites one resolved grid point.
  void write(const glm::ivec2& point, int slot, const glm::vec4& displacement, std::int32_t site);

  const AtlasLayout& atlas() const { return atlas_; }
  /// RGBA32F atlas: vector to the closest point and signed distance, local units.
  GLuint displacements() const { return displacements_.id(); }
  /// R32I atlas of the resolved site ids.
  GLuint sites() const { return sites_.id(); }

private:
  void uploadConnectivity(const SiteSet& sites);
  void uploadPositions(const SiteSet& sites, const std::vector<glm::vec4>& normals);
  void uploadPolygons(const std::vector<PolygonChunk>& chunks);
  void createDrawTarget();
  void bindVertexFormat();

  AtlasLayout atlas_;
  GridFrame frame_;
  FieldSign sign_;
  int firstEdge_;
  int firstVertex_;
  float depthScale_;

  gl::Buffer points_, faces_, faceEdges_, edges_, lines_, normals_, holes_;
  gl::Buffer vertices_, indices_;
  gl::VertexArray polygonFormat_, noVertices_;
  std::vector<GLsizei> drawCounts_;
  std::vector<GLint> drawBases_;
  std::vector<const void*> drawOffsets_;

  gl::Texture winners_, depth_, displacements_, sites_;
  gl::Framebuffer drawTarget_, resolveTarget_;
};

} // namespace medial
