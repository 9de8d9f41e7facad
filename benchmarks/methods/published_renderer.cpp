#include "methods/published_renderer.h"

#include "methods/published_shaders.h"

#include <cstddef>

namespace medial::benchmark
{
namespace
{

template <typename T>
void upload(const gl::Buffer& buffer, const std::vector<T>& values)
{
  glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
    GL_STREAM_DRAW);
}

} // namespace

PublishedRenderer::PublishedRenderer(const AtlasLayout& atlas, float depthPerUnit)
  : target_(atlas)
  , program_(kPublishedVertex, kPublishedFragment)
  , vertices_(gl::createBuffer())
  , indices_(gl::createBuffer())
  , format_(gl::createVertexArray())
{
  program_.set("atlasSize", static_cast<float>(atlas.size().x), static_cast<float>(atlas.size().y));
  program_.set("depthScale", depthPerUnit);
  const GLuint format = format_.id();
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

void PublishedRenderer::draw(const std::vector<PolygonChunk>& chunks)
{
  program_.use();
  target_.begin();
  glBindVertexArray(format_.id());
  for (const PolygonChunk& chunk : chunks)
  {
    if (!chunk.indices.empty())
    {
      upload(vertices_, chunk.vertices);
      upload(indices_, chunk.indices);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(chunk.indices.size()), GL_UNSIGNED_INT,
        nullptr);
    }
  }
  target_.finish();
}

} // namespace medial::benchmark
