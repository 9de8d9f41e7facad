#include "field/engines/rasteriser/slab_renderer.h"

#include "field/engines/rasteriser/atlas_texture.h"
#include "gl/shader_program.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Returns a power of two, which rounds nothing, that brings every distance on the grid below 1.
float depthScale(const DeviceMesh& mesh, const GridFrame& frame)
{
  const double longest = 2.0 * (mesh.reach() + glm::length(frame.first)) + 1.0;
  return static_cast<float>(std::exp2(-std::ceil(std::log2(longest)) - 1.0));
}

} // namespace

SlabRenderer::SlabRenderer(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const AtlasLayout& atlas)
  : atlas_(atlas)
  , mesh_(mesh, connectivity, kernels_)
  , rectangles_(mesh_, kernels_)
  , holes_(gl::createBuffer())
  , noVertices_(gl::createVertexArray())
{
  glNamedBufferData(holes_.id(), sizeof(std::uint32_t), nullptr, GL_DYNAMIC_READ);
  const glm::ivec2 size = atlas.size();
  displacements_ = gl::createTexture2D(GL_RGBA32F, size.x, size.y);
  sites_ = gl::createTexture2D(GL_R32I, size.x, size.y);
  resolveTarget_ = gl::createFramebuffer({ displacements_.id(), sites_.id() });
}

void SlabRenderer::createDrawTarget()
{
  const glm::ivec2 size = atlas_.size();
  winners_ = gl::createTexture2D(GL_R32I, size.x, size.y);
  depth_ = gl::createTexture2D(GL_DEPTH_COMPONENT32F, size.x, size.y);
  drawTarget_ = gl::createFramebuffer({ winners_.id() }, depth_.id());
  polygons_.emplace();
}

void SlabRenderer::move(const TriangleMesh& mesh, const std::vector<glm::vec4>& normals,
  const GridFrame& frame)
{
  frame_ = frame;
  hasNormals_ = !normals.empty();
  mesh_.pack(mesh, frame, frame.reach());
  mesh_.move(kernels_);
  rectangles_.move();
  depthScale_ = depthScale(mesh_, frame);
  const auto bytes = static_cast<std::int64_t>(normals.size() * sizeof(glm::vec4));
  obtainBuffer(normals_, bytes);
  kernels_.upload(normals_, 0, bytes, normals.data());
}

void SlabRenderer::carryLastSlice(int previousSlices)
{
  const glm::ivec2 from = atlas_.slotOrigin(previousSlices);
  for (GLuint texture : { displacements_.id(), sites_.id() })
  {
    glCopyImageSubData(texture, GL_TEXTURE_2D, 0, from.x, from.y, 0, texture, GL_TEXTURE_2D, 0, 0,
      0, 0, atlas_.sliceSize.x, atlas_.sliceSize.y, 1);
  }
}

void SlabRenderer::draw(RectangleSource& source, const Extent& slab)
{
  if (!drawTarget_)
  {
    this->createDrawTarget();
  }
  constexpr GLint kNoSite[4] = { -1, -1, -1, -1 };
  constexpr GLfloat kFar = 1.0f;
  glBindFramebuffer(GL_FRAMEBUFFER, drawTarget_.id());
  glViewport(0, 0, atlas_.size().x, atlas_.size().y);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glClearBufferiv(GL_COLOR, 0, kNoSite);
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  polygons_->draw(source, mesh_, *frame_, slab, atlas_, depthScale_, kernels_);
  glDisable(GL_DEPTH_TEST);
  gl::checkGl("drawing polygons");
  // Wait here, so that each phase is charged with its own time.
  glFinish();
}

std::uint32_t SlabRenderer::resolve(const Extent& slab)
{
  const gl::ShaderProgram& program = gl::cachedProgram("atlas_pass.vert", "resolve.frag");
  program.set("closestSite", 0);
  program.set("sliceSize", atlas_.sliceSize);
  program.set("columns", atlas_.columns);
  program.set("firstSlot", 1);
  program.set("endSlot", 1 + slab.size(2));
  program.set("exactFirst", frame_->sample({ slab.min[0], slab.min[1], slab.min[2] - 1 }));
  program.set("exactSpacing", frame_->step);
  program.set("hasNormals", hasNormals_ ? 1 : 0);
  mesh_.describe(program);
  program.use();
  const gl::Buffer* buffers[] = { &mesh_.connectivity(), &mesh_.points(), &mesh_.faces(), &normals_,
    &holes_ };
  GLuint binding = 0;
  for (const gl::Buffer* buffer : buffers)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer->id());
  }
  std::uint32_t holes = 0;
  glNamedBufferSubData(holes_.id(), 0, sizeof(holes), &holes);
  glBindTextureUnit(0, winners_.id());
  glBindFramebuffer(GL_FRAMEBUFFER, resolveTarget_.id());
  glViewport(0, 0, atlas_.size().x, atlas_.size().y);
  glBindVertexArray(noVertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(holes_.id(), 0, sizeof(holes), &holes);
  gl::checkGl("resolving distances");
  return holes;
}

void SlabRenderer::readSites(int slices, std::int32_t* sites) const
{
  readSlots(sites_.id(), atlas_, 1, slices, GL_RED_INTEGER, GL_INT, sizeof(std::int32_t), sites);
}

void SlabRenderer::readDisplacements(int slices, glm::vec4* displacements) const
{
  readSlots(displacements_.id(), atlas_, 1, slices, GL_RGBA, GL_FLOAT, sizeof(glm::vec4),
    displacements);
}

void SlabRenderer::write(const glm::ivec2& point, int slot,
  const std::vector<glm::vec4>& displacements, const std::vector<std::int32_t>& sites)
{
  const glm::ivec2 pixel = atlas_.slotOrigin(slot) + point;
  const auto count = static_cast<GLsizei>(sites.size());
  glTextureSubImage2D(displacements_.id(), 0, pixel.x, pixel.y, count, 1, GL_RGBA, GL_FLOAT,
    displacements.data());
  glTextureSubImage2D(sites_.id(), 0, pixel.x, pixel.y, count, 1, GL_RED_INTEGER, GL_INT,
    sites.data());
}

} // namespace medial
