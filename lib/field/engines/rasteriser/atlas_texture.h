#pragma once

#include "field/engines/rasteriser/atlas_layout.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace medial
{

/// Reads slots [firstSlot, firstSlot + count) of an atlas texture one after the other, x fastest.
/// @param bytesPerPixel of `format` and `type`, which must be the texture's own.
void readSlots(GLuint texture, const AtlasLayout& atlas, int firstSlot, int count, GLenum format,
  GLenum type, std::size_t bytesPerPixel, void* values);

} // namespace medial
