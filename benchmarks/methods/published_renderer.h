#pragma once

#include "methods/baseline_slices.h"

#include "medial/distance/polygon_builder.h"

#include <vector>

namespace medial::benchmark
{

/// Draws polygons with distance vectors, keeping the shortest. Lives on the GPU thread.
class PublishedRenderer
{
public:
  PublishedRenderer(const AtlasLayout& atlas, float depthPerUnit);

  void draw(const std::vector<PolygonChunk>& chunks);

  const SliceTarget& target() const { return target_; }

private:
  SliceTarget target_;
  float depthPerUnit_;
  gpu::Buffer vertices_, indices_;
  gpu::VertexArray format_;
};

} // namespace medial::benchmark
