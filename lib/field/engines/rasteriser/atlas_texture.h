#pragma once

#include "field/engines/rasteriser/atlas_layout.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace medial
{

/// Reads slots [firstSlot, firstSlot + count) of an atlas texture one after the other, x fastest.
/// @param format, type those of the texture itself.
/// @param bytesPerPixel size of a pixel of this format and type.
void readSlots(GLuint texture, const AtlasLayout& atlas, int firstSlot, int count, GLenum format,
  GLenum type, std::size_t bytesPerPixel, void* values);

} // namespace medial
