#include "field/engines/rasteriser/slab_renderer.h"

#include "field/engines/rasteriser/atlas_texture.h"
#include "gl/shader_program.h"
#include "medial/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace medial
{
namespace
{

enum StorageBinding : GLuint
{
  kPointsBinding,
  kFacesBinding,
  kFaceEdgesBinding,
  kEdgesBinding,
  kLinesBinding,
  kNormalsBinding,
  kHolesBinding
};

template <typename T>
gl::Buffer uploaded(const std::vector<T>& values)
{
  return gl::createStorageBuffer(static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data());
}

/// Overwrites a buffer of the same size, or makes a new one.
template <typename T>
void upload(const std::vector<T>& values, gl::Buffer& buffer)
{
  if (!buffer)
  {
    buffer = uploaded(values);
    return;
  }
  glNamedBufferSubData(buffer.id(), 0, static_cast<GLsizeiptr>(values.size() * sizeof(T)),
    values.data());
}

std::vector<glm::ivec4> padded(const std::vector<glm::ivec3>& values)
{
  std::vector<glm::ivec4> result;
  result.reserve(values.size());
  for (const glm::ivec3& value : values)
  {
    result.emplace_back(value, 0);
  }
  return result;
}

/// Layout of Line in resolve.frag.
struct EdgeLine
{
  glm::vec4 foot;
  glm::vec4 direction;
};

std::vector<EdgeLine> edgeLines(const SiteSet& sites)
{
  std::vector<EdgeLine> lines;
  lines.reserve(sites.edges().size());
  for (const glm::ivec2& ends : sites.edges())
  {
    const glm::dvec3& p = sites.points()[ends[0]];
    const glm::dvec3& q = sites.points()[ends[1]];
    const glm::dvec3 direction = glm::normalize(q - p);
    const double start = glm::dot(p, direction);
    lines.push_back({ { glm::vec3(p - start * direction), static_cast<float>(start) },
      { glm::vec3(direction), static_cast<float>(glm::dot(q, direction)) } });
  }
  return lines;
}

/// Returns a power of two, which rounds nothing, that brings every distance on the grid below 1.
float depthScale(const SiteSet& sites, const GridFrame& frame)
{
  double reach = 0.0;
  for (const glm::dvec3& point : sites.points())
  {
    reach = std::max(reach, glm::length(point));
  }
  const double longest = 2.0 * (reach + glm::length(frame.first)) + 1.0;
  return static_cast<float>(std::exp2(-std::ceil(std::log2(longest)) - 1.0));
}

} // namespace

SlabRenderer::SlabRenderer(const SiteSet& sites, const std::vector<glm::vec4>& normals,
  const GridFrame& frame, const AtlasLayout& atlas, FieldSign sign)
  : atlas_(atlas)
  , frame_(frame)
  , sign_(sign)
  , firstEdge_(sites.firstEdge())
  , firstVertex_(sites.firstVertex())
  , depthScale_(depthScale(sites, frame))
{
  this->uploadConnectivity(sites);
  this->uploadPositions(sites, normals);
  const glm::ivec2 size = atlas.size();
  displacements_ = gl::createTexture2D(GL_RGBA32F, size.x, size.y);
  sites_ = gl::createTexture2D(GL_R32I, size.x, size.y);
  resolveTarget_ = gl::createFramebuffer({ displacements_.id(), sites_.id() });
  noVertices_ = gl::createVertexArray();
}

void SlabRenderer::createDrawTarget()
{
  const glm::ivec2 size = atlas_.size();
  winners_ = gl::createTexture2D(GL_R32I, size.x, size.y);
  depth_ = gl::createTexture2D(GL_DEPTH_COMPONENT32F, size.x, size.y);
  drawTarget_ = gl::createFramebuffer({ winners_.id() }, depth_.id());
  this->bindVertexFormat();
}

void SlabRenderer::move(const SiteSet& sites, const std::vector<glm::vec4>& normals,
  const GridFrame& frame, FieldSign sign)
{
  frame_ = frame;
  sign_ = sign;
  depthScale_ = depthScale(sites, frame);
  this->uploadPositions(sites, normals);
}

void SlabRenderer::uploadConnectivity(const SiteSet& sites)
{
  faces_ = uploaded(padded(sites.faces()));
  faceEdges_ = uploaded(padded(sites.faceEdges()));
  edges_ = uploaded(sites.edges());
  holes_ = gl::createBuffer();
  glNamedBufferData(holes_.id(), sizeof(std::uint32_t), nullptr, GL_DYNAMIC_READ);
}

void SlabRenderer::uploadPositions(const SiteSet& sites, const std::vector<glm::vec4>& normals)
{
  std::vector<glm::vec4> points;
  points.reserve(sites.points().size());
  for (const glm::dvec3& point : sites.points())
  {
    points.emplace_back(glm::vec3(point), 0.0f);
  }
  upload(points, points_);
  upload(edgeLines(sites), lines_);
  upload(normals, normals_);
}

void SlabRenderer::bindVertexFormat()
{
  vertices_ = gl::createBuffer();
  indices_ = gl::createBuffer();
  polygonFormat_ = gl::createVertexArray();
  const GLuint format = polygonFormat_.id();
  glVertexArrayVertexBuffer(format, 0, vertices_.id(), 0, sizeof(PolygonVertex));
  glVertexArrayElementBuffer(format, indices_.id());
  glVertexArrayAttribFormat(format, 0, 2, GL_FLOAT, GL_FALSE, offsetof(PolygonVertex, position));
  glVertexArrayAttribFormat(format, 1, 3, GL_FLOAT, GL_FALSE, offsetof(PolygonVertex, distance));
  glVertexArrayAttribIFormat(format, 2, 1, GL_INT, offsetof(PolygonVertex, site));
  for (GLuint attribute = 0; attribute < 3; ++attribute)
  {
    glVertexArrayAttribBinding(format, attribute, 0);
    glEnableVertexArrayAttrib(format, attribute);
  }
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

void SlabRenderer::uploadPolygons(const std::vector<PolygonChunk>& chunks)
{
  drawCounts_.clear();
  drawBases_.clear();
  drawOffsets_.clear();
  std::size_t vertexCount = 0;
  std::size_t indexCount = 0;
  for (const PolygonChunk& chunk : chunks)
  {
    drawCounts_.push_back(static_cast<GLsizei>(chunk.indices.size()));
    drawBases_.push_back(static_cast<GLint>(vertexCount));
    drawOffsets_.push_back(reinterpret_cast<const void*>(indexCount * sizeof(std::uint32_t)));
    vertexCount += chunk.vertices.size();
    indexCount += chunk.indices.size();
  }
  constexpr std::size_t kMaxVertices = std::numeric_limits<GLint>::max();
  if (vertexCount > kMaxVertices)
  {
    throw Error(ErrorCode::GpuLimit,
      "the polygons of a slab have " + std::to_string(vertexCount) + " corners, more than " +
        std::to_string(kMaxVertices) + "; allow less memory for slabs");
  }
  const auto allocate = [](const gl::Buffer& buffer, std::size_t bytes)
  {
    glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(std::max<std::size_t>(bytes, 16)),
      nullptr, GL_STREAM_DRAW);
  };
  allocate(vertices_, vertexCount * sizeof(PolygonVertex));
  allocate(indices_, indexCount * sizeof(std::uint32_t));
  gl::checkGl("allocating polygon buffers");
  for (std::size_t i = 0; i < chunks.size(); ++i)
  {
    const PolygonChunk& chunk = chunks[i];
    if (chunk.indices.empty())
    {
      continue;
    }
    glNamedBufferSubData(vertices_.id(),
      static_cast<GLintptr>(static_cast<std::size_t>(drawBases_[i]) * sizeof(PolygonVertex)),
      static_cast<GLsizeiptr>(chunk.vertices.size() * sizeof(PolygonVertex)),
      chunk.vertices.data());
    glNamedBufferSubData(indices_.id(), reinterpret_cast<GLintptr>(drawOffsets_[i]),
      static_cast<GLsizeiptr>(chunk.indices.size() * sizeof(std::uint32_t)), chunk.indices.data());
  }
}

void SlabRenderer::draw(const std::vector<PolygonChunk>& chunks)
{
  if (!drawTarget_)
  {
    this->createDrawTarget();
  }
  this->uploadPolygons(chunks);
  const gl::ShaderProgram& program =
    gl::cachedProgram("distance_field.vert", "distance_field.frag");
  program.set("atlasSize", glm::vec2(atlas_.size()));
  program.set("depthScale", depthScale_);
  program.use();
  constexpr GLint kNoSite[4] = { -1, -1, -1, -1 };
  constexpr GLfloat kFar = 1.0f;
  glBindFramebuffer(GL_FRAMEBUFFER, drawTarget_.id());
  glViewport(0, 0, atlas_.size().x, atlas_.size().y);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LESS);
  glClearBufferiv(GL_COLOR, 0, kNoSite);
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  glBindVertexArray(polygonFormat_.id());
  glMultiDrawElementsBaseVertex(GL_TRIANGLES, drawCounts_.data(), GL_UNSIGNED_INT,
    drawOffsets_.data(), static_cast<GLsizei>(drawCounts_.size()), drawBases_.data());
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
  program.set("origin", glm::vec3(frame_.sample({ slab.min[0], slab.min[1], slab.min[2] - 1 })));
  program.set("spacing", glm::vec3(frame_.step));
  program.set("firstEdge", firstEdge_);
  program.set("firstVertex", firstVertex_);
  program.set("signedField", hasPseudonormals(sign_) ? 1 : 0);
  program.set("orientation", sign_ == FieldSign::Inward ? -1.0f : 1.0f);
  program.use();
  const GLuint buffers[] = { points_.id(), faces_.id(), faceEdges_.id(), edges_.id(), lines_.id(),
    normals_.id(), holes_.id() };
  for (GLuint binding = kPointsBinding; binding <= kHolesBinding; ++binding)
  {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffers[binding]);
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

void SlabRenderer::write(const glm::ivec2& point, int slot, const glm::vec4& displacement,
  std::int32_t site)
{
  const glm::ivec2 pixel = atlas_.slotOrigin(slot) + point;
  glTextureSubImage2D(displacements_.id(), 0, pixel.x, pixel.y, 1, 1, GL_RGBA, GL_FLOAT,
    &displacement);
  glTextureSubImage2D(sites_.id(), 0, pixel.x, pixel.y, 1, 1, GL_RED_INTEGER, GL_INT, &site);
}

} // namespace medial
