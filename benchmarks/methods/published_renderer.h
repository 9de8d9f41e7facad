#pragma once

#include "methods/baseline_slices.h"
#include "methods/published_polygons.h"
#include "methods/text_program.h"

#include <vector>

namespace medial::benchmark
{

/// Draws polygons with distance vectors and keeps the shortest vector. For use on the GPU thread.
class PublishedRenderer
{
public:
  PublishedRenderer(const AtlasLayout& atlas, float depthPerUnit);

  void draw(const std::vector<PolygonChunk>& chunks);

  const SliceTarget& target() const { return target_; }

private:
  SliceTarget target_;
  TextProgram program_;
  gl::Buffer vertices_, indices_;
  gl::VertexArray format_;
};

} // namespace medial::benchmark
