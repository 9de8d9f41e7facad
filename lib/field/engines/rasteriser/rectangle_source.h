#pragma once

#include "gl/gl_objects.h"

#include <glm/glm.hpp>

namespace medial
{

/// The grid points of a slab, in one layer of tiles, that the polygons of a site must cover: the
/// bounding box of the tiles in which the site can be closest, or a part of it at most 64 points
/// long. Both ends are included.
struct SiteRectangle
{
  int site;
  glm::ivec3 low;
  glm::ivec3 high;
};

/// Lists rectangles on the device, layer by layer, with sites ascending within a layer. GPU thread
/// only.
class RectangleSource
{
public:
  virtual ~RectangleSource() = default;

  /// Writes the next rectangles.
  /// @param room for so many.
  /// @return their number; 0 after the last.
  virtual int next(const gl::Buffer& rectangles, int room) = 0;
};

} // namespace medial
