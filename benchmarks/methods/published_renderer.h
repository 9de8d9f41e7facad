#pragma once

#include "methods/baseline_slices.h"

#include "field/engines/rasteriser/polygon_builder.h"

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
  float depthPerUnit_;
  gl::Buffer vertices_, indices_;
  gl::VertexArray format_;
};

} // namespace medial::benchmark
