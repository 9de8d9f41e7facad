#include "field/engines/rasteriser/atlas_texture.h"

#include "gl/gl_objects.h"

#include <cstdint>

namespace medial
{

void readSlots(GLuint texture, const AtlasLayout& atlas, int firstSlot, int count, GLenum format,
  GLenum type, std::size_t bytesPerPixel, void* values)
{
  const glm::ivec2& size = atlas.sliceSize;
  const std::size_t sliceBytes = bytesPerPixel * static_cast<std::size_t>(size.x) * size.y;
  // An integer, since it may be an offset.
  const auto start = reinterpret_cast<std::uintptr_t>(values);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  for (int i = 0; i < count; ++i)
  {
    const glm::ivec2 from = atlas.slotOrigin(firstSlot + i);
    glGetTextureSubImage(texture, 0, from.x, from.y, 0, size.x, size.y, 1, format, type,
      static_cast<GLsizei>(sliceBytes), reinterpret_cast<void*>(start + sliceBytes * i));
  }
  gl::checkGl("reading a texture back");
}

} // namespace medial
