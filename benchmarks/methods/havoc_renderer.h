#pragma once

#include "methods/baseline_slices.h"
#include "methods/havoc_functions.h"
#include "methods/text_program.h"

#include <map>
#include <vector>

namespace medial::benchmark
{

/// Draws the distance functions of one slice and keeps the smallest distance. Functions of points
/// and segments are instances of a few templates. For use on the GPU thread.
class HavocRenderer
{
public:
  HavocRenderer(const GridFrame& frame, const glm::ivec2& sliceSize, float depthPerUnit);

  void draw(const SliceFunctions& functions);

  const SliceTarget& target() const { return target_; }
  /// Triangles drawn so far.
  double triangles() const { return triangles_; }

private:
  /// Nodes of a tessellated function, to be placed by the vertex shader.
  struct Template
  {
    gl::Buffer nodes, indices;
    GLsizei indexCount = 0;
  };

  static Template makeTemplate(const std::vector<glm::vec3>& nodes,
    const std::vector<std::uint32_t>& indices);
  static Template pointTemplate(const PointFineness& fineness);
  static Template segmentTemplate(int sectors);

  void describeFaces();
  void describePoints();
  void describeSegments();
  void drawInstances(const gl::VertexArray& format, const Template& shape, GLsizei count);

  SliceTarget target_;
  TextProgram faceProgram_, pointProgram_, segmentProgram_;
  gl::VertexArray faceFormat_, pointFormat_, segmentFormat_;
  gl::Buffer faceVertices_, faceIndices_, instances_;
  std::map<PointFineness, Template> pointTemplates_;
  std::map<int, Template> segmentTemplates_;
  double triangles_ = 0.0;
};

} // namespace medial::benchmark
