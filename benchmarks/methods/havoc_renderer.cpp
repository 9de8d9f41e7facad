#include "methods/havoc_renderer.h"

#include "methods/havoc_shaders.h"

#include <cstddef>
#include <string>

namespace medial::benchmark
{
namespace
{

constexpr GLuint kNodeBinding = 0;
constexpr GLuint kInstanceBinding = 1;

AtlasLayout oneSlice(const glm::ivec2& sliceSize)
{
  AtlasLayout atlas;
  atlas.sliceSize = sliceSize;
  atlas.slabSlices = 1;
  return atlas;
}

template <typename T>
void upload(const gl::Buffer& buffer, const std::vector<T>& values)
{
  glNamedBufferData(buffer.id(), static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
    GL_STREAM_DRAW);
}

void describeFloats(const gl::VertexArray& format, GLuint attribute, GLuint binding, GLint count,
  std::size_t offset)
{
  glVertexArrayAttribFormat(format.id(), attribute, count, GL_FLOAT, GL_FALSE,
    static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(format.id(), attribute, binding);
  glEnableVertexArrayAttrib(format.id(), attribute);
}

void describeSite(const gl::VertexArray& format, GLuint attribute, GLuint binding,
  std::size_t offset)
{
  glVertexArrayAttribIFormat(format.id(), attribute, 1, GL_INT, static_cast<GLuint>(offset));
  glVertexArrayAttribBinding(format.id(), attribute, binding);
  glEnableVertexArrayAttrib(format.id(), attribute);
}

void addQuad(std::vector<std::uint32_t>& indices, std::uint32_t a, std::uint32_t b, std::uint32_t c,
  std::uint32_t d)
{
  indices.insert(indices.end(), { a, b, c, a, c, d });
}

} // namespace

HavocRenderer::HavocRenderer(const GridFrame& frame, const glm::ivec2& sliceSize,
  float depthPerUnit)
  : target_(oneSlice(sliceSize))
  , faceProgram_(std::string(kHavocPlacement) + kHavocFace, kHavocFragment)
  , pointProgram_(std::string(kHavocPlacement) + kHavocPoint, kHavocFragment)
  , segmentProgram_(std::string(kHavocPlacement) + kHavocSegment, kHavocFragment)
  , faceVertices_(gl::createBuffer())
  , faceIndices_(gl::createBuffer())
  , instances_(gl::createBuffer())
{
  // Grid point (0, 0) is at the centre of the first pixel.
  const glm::dvec2 perPoint = 2.0 / glm::dvec2(sliceSize);
  const glm::dvec2 start = 0.5 * perPoint - 1.0;
  const glm::vec2 perUnit(perPoint / glm::dvec2(frame.step));
  const glm::vec2 offset(start - glm::dvec2(frame.first) * perPoint / glm::dvec2(frame.step));
  faceProgram_.set("scale", static_cast<float>(perPoint.x), static_cast<float>(perPoint.y));
  faceProgram_.set("offset", static_cast<float>(start.x), static_cast<float>(start.y));
  for (const TextProgram* program : { &pointProgram_, &segmentProgram_ })
  {
    program->set("scale", perUnit.x, perUnit.y);
    program->set("offset", offset.x, offset.y);
  }
  for (const TextProgram* program : { &faceProgram_, &pointProgram_, &segmentProgram_ })
  {
    program->set("depthPerUnit", depthPerUnit);
  }
  this->describeFaces();
  this->describePoints();
  this->describeSegments();
}

void HavocRenderer::describeFaces()
{
  faceFormat_ = gl::createVertexArray();
  glVertexArrayVertexBuffer(faceFormat_.id(), 0, faceVertices_.id(), 0, sizeof(FaceVertex));
  glVertexArrayElementBuffer(faceFormat_.id(), faceIndices_.id());
  describeFloats(faceFormat_, 0, 0, 2, offsetof(FaceVertex, position));
  describeFloats(faceFormat_, 1, 0, 1, offsetof(FaceVertex, distance));
  describeSite(faceFormat_, 2, 0, offsetof(FaceVertex, site));
}

void HavocRenderer::describePoints()
{
  pointFormat_ = gl::createVertexArray();
  glVertexArrayVertexBuffer(pointFormat_.id(), kInstanceBinding, instances_.id(), 0,
    sizeof(PointInstance));
  glVertexArrayBindingDivisor(pointFormat_.id(), kInstanceBinding, 1);
  describeFloats(pointFormat_, 0, kNodeBinding, 3, 0);
  describeFloats(pointFormat_, 1, kInstanceBinding, 2, offsetof(PointInstance, centre));
  describeFloats(pointFormat_, 2, kInstanceBinding, 1, offsetof(PointInstance, height));
  describeFloats(pointFormat_, 3, kInstanceBinding, 1, offsetof(PointInstance, growth));
  describeSite(pointFormat_, 4, kInstanceBinding, offsetof(PointInstance, site));
}

void HavocRenderer::describeSegments()
{
  segmentFormat_ = gl::createVertexArray();
  glVertexArrayVertexBuffer(segmentFormat_.id(), kInstanceBinding, instances_.id(), 0,
    sizeof(SegmentInstance));
  glVertexArrayBindingDivisor(segmentFormat_.id(), kInstanceBinding, 1);
  describeFloats(segmentFormat_, 0, kNodeBinding, 3, 0);
  describeFloats(segmentFormat_, 1, kInstanceBinding, 2, offsetof(SegmentInstance, from));
  describeFloats(segmentFormat_, 2, kInstanceBinding, 2, offsetof(SegmentInstance, to));
  describeFloats(segmentFormat_, 3, kInstanceBinding, 2, offsetof(SegmentInstance, across));
  describeFloats(segmentFormat_, 4, kInstanceBinding, 2, offsetof(SegmentInstance, w));
  describeFloats(segmentFormat_, 5, kInstanceBinding, 1, offsetof(SegmentInstance, reach));
  describeFloats(segmentFormat_, 6, kInstanceBinding, 1, offsetof(SegmentInstance, split));
  describeSite(segmentFormat_, 7, kInstanceBinding, offsetof(SegmentInstance, site));
}

HavocRenderer::Template HavocRenderer::makeTemplate(const std::vector<glm::vec3>& nodes,
  const std::vector<std::uint32_t>& indices)
{
  Template result;
  result.nodes = gl::createStorageBuffer(static_cast<GLsizeiptr>(nodes.size() * sizeof(glm::vec3)),
    nodes.data());
  result.indices = gl::createStorageBuffer(
    static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data());
  result.indexCount = static_cast<GLsizei>(indices.size());
  return result;
}

HavocRenderer::Template HavocRenderer::pointTemplate(const PointFineness& fineness)
{
  const double fullTurn = 4.0 * std::acos(0.0);
  std::vector<glm::vec3> nodes{ glm::vec3(0.0f) };
  std::vector<std::uint32_t> indices;
  const auto sectors = static_cast<std::uint32_t>(fineness.sectors);
  for (int ring = 1; ring <= fineness.rings; ++ring)
  {
    const auto first = static_cast<std::uint32_t>(nodes.size());
    for (std::uint32_t sector = 0; sector < sectors; ++sector)
    {
      const double angle = fullTurn * sector / sectors;
      nodes.emplace_back(std::cos(angle), std::sin(angle),
        static_cast<double>(ring) / fineness.rings);
      const std::uint32_t next = (sector + 1) % sectors;
      if (ring == 1)
      {
        indices.insert(indices.end(), { 0, first + sector, first + next });
      }
      else
      {
        addQuad(indices, first - sectors + sector, first + sector, first + next,
          first - sectors + next);
      }
    }
  }
  return makeTemplate(nodes, indices);
}

HavocRenderer::Template HavocRenderer::segmentTemplate(int sectors)
{
  std::vector<glm::vec3> nodes;
  std::vector<std::uint32_t> indices;
  for (const float side : { -1.0f, 1.0f })
  {
    for (int ray = 0; ray <= sectors; ++ray)
    {
      const auto first = static_cast<std::uint32_t>(nodes.size());
      nodes.emplace_back(side, static_cast<float>(ray), 0.0f);
      nodes.emplace_back(side, static_cast<float>(ray), 1.0f);
      if (ray < sectors)
      {
        addQuad(indices, first, first + 1, first + 3, first + 2);
      }
    }
  }
  return makeTemplate(nodes, indices);
}

void HavocRenderer::drawInstances(const gl::VertexArray& format, const Template& shape,
  GLsizei count)
{
  glVertexArrayVertexBuffer(format.id(), kNodeBinding, shape.nodes.id(), 0, sizeof(glm::vec3));
  glVertexArrayElementBuffer(format.id(), shape.indices.id());
  glBindVertexArray(format.id());
  glDrawElementsInstanced(GL_TRIANGLES, shape.indexCount, GL_UNSIGNED_INT, nullptr, count);
  triangles_ += shape.indexCount / 3.0 * count;
}

void HavocRenderer::draw(const SliceFunctions& functions)
{
  target_.begin();
  faceProgram_.use();
  upload(faceVertices_, functions.faceVertices);
  upload(faceIndices_, functions.faceIndices);
  glBindVertexArray(faceFormat_.id());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(functions.faceIndices.size()), GL_UNSIGNED_INT,
    nullptr);
  triangles_ += static_cast<double>(functions.faceIndices.size()) / 3.0;

  segmentProgram_.use();
  for (const auto& [sectors, instances] : functions.segments)
  {
    const auto found = segmentTemplates_.find(sectors);
    const Template& shape = found != segmentTemplates_.end()
      ? found->second
      : segmentTemplates_.emplace(sectors, segmentTemplate(sectors)).first->second;
    segmentProgram_.set("rays", static_cast<float>(sectors));
    upload(instances_, instances);
    this->drawInstances(segmentFormat_, shape, static_cast<GLsizei>(instances.size()));
  }

  pointProgram_.use();
  for (const auto& [fineness, instances] : functions.points)
  {
    const auto found = pointTemplates_.find(fineness);
    const Template& shape = found != pointTemplates_.end()
      ? found->second
      : pointTemplates_.emplace(fineness, pointTemplate(fineness)).first->second;
    upload(instances_, instances);
    this->drawInstances(pointFormat_, shape, static_cast<GLsizei>(instances.size()));
  }
  target_.finish();
}

} // namespace medial::benchmark
