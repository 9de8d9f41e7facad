#include "field/engines/rasteriser/rasteriser_selection.h"

#include "field/engines/rasteriser/atlas_texture.h"
#include "gl/shader_program.h"

#include <cmath>

namespace medial
{

RasteriserSelection::RasteriserSelection(const CrossingSelection& selection, const GridFrame& frame,
  const InsideRows* inside)
  : selection_(selection)
  , frame_(frame)
  , inside_(inside)
  , noVertices_(gl::createVertexArray())
{
}

void RasteriserSelection::allocate(const AtlasLayout& atlas)
{
  const glm::ivec2 size = atlas.size();
  directions_ = gl::createTexture2D(GL_RGBA32F, size.x, size.y);
  selected_ = gl::createTexture2D(GL_R8UI, size.x, size.y);
  directionTarget_ = gl::createFramebuffer({ directions_.id() });
  selectionTarget_ = gl::createFramebuffer({ selected_.id() });
}

void RasteriserSelection::process(const SlabRenderer& renderer, const Extent& slab, bool carried)
{
  if (!directions_)
  {
    this->allocate(renderer.atlas());
  }
  glViewport(0, 0, renderer.atlas().size().x, renderer.atlas().size().y);
  glBindVertexArray(noVertices_.id());
  this->computeDirections(renderer);
  this->select(renderer.atlas(), slab.size(2), carried);
  gl::checkGl("selecting the medial axis");
  this->collect(renderer, slab);
  requireRoomForAxis(crossings_.size());
}

void RasteriserSelection::computeDirections(const SlabRenderer& renderer)
{
  const gl::ShaderProgram& program =
    gl::cachedProgram("atlas_pass.vert", "neighbour_direction.frag");
  program.set("displacement", 0);
  program.use();
  glBindTextureUnit(0, renderer.displacements());
  glBindFramebuffer(GL_FRAMEBUFFER, directionTarget_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void RasteriserSelection::select(const AtlasLayout& atlas, int slices, bool carried)
{
  const gl::ShaderProgram& program = gl::cachedProgram("atlas_pass.vert", "medial_axis.frag");
  program.set("direction", 0);
  program.set("sliceSize", atlas.sliceSize);
  program.set("columns", atlas.columns);
  program.set("firstSlot", carried ? 0 : 1);
  program.set("endSlot", 1 + slices);
  program.set("spacing", glm::vec3(frame_.step));
  program.set("cosineLimit", static_cast<float>(std::cos(glm::radians(selection_.angle))));
  // Without a sign in the textures the sides are told apart on the host.
  const Side side = inside_ != nullptr ? Side::Both : selection_.side;
  program.set("side", side == Side::Interior ? -1.0f : (side == Side::Exterior ? 1.0f : 0.0f));
  program.use();
  glBindTextureUnit(0, directions_.id());
  glBindFramebuffer(GL_FRAMEBUFFER, selectionTarget_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void RasteriserSelection::collect(const SlabRenderer& renderer, const Extent& slab)
{
  const AtlasLayout& atlas = renderer.atlas();
  const int slots = 1 + slab.size(2);
  const std::size_t slice = static_cast<std::size_t>(atlas.sliceSize.x) * atlas.sliceSize.y;
  masks_.resize(slice * slots);
  sites_.resize(slice * slots);
  readSlots(selected_.id(), atlas, 0, slots, GL_RED_INTEGER, GL_UNSIGNED_BYTE, sizeof(std::uint8_t),
    masks_.data());
  readSlots(renderer.sites(), atlas, 0, slots, GL_RED_INTEGER, GL_INT, sizeof(std::int32_t),
    sites_.data());
  for (int slot = 0; slot < slots; ++slot)
  {
    for (std::size_t i = 0; i < slice; ++i)
    {
      if (masks_[slot * slice + i] != 0)
      {
        this->addCrossings(slab, atlas, slot, i);
      }
    }
  }
}

bool RasteriserSelection::isWanted(Crossing& crossing) const
{
  glm::ivec3 neighbour = crossing.voxel;
  ++neighbour[crossing.axis];
  crossing.inside = inside_->contains(crossing.voxel);
  const bool wanted =
    selection_.side == Side::Both || crossing.inside == (selection_.side == Side::Interior);
  return wanted && crossing.inside == inside_->contains(neighbour);
}

void RasteriserSelection::addCrossings(const Extent& slab, const AtlasLayout& atlas, int slot,
  std::size_t index)
{
  const auto width = static_cast<std::size_t>(atlas.sliceSize.x);
  const std::size_t slice = width * atlas.sliceSize.y;
  const std::size_t stride[3] = { 1, width, slice };
  const glm::ivec3 voxel(slab.min[0] + static_cast<int>(index % width),
    slab.min[1] + static_cast<int>(index / width), slab.min[2] + slot - 1);
  const std::size_t here = slot * slice + index;
  const bool inside = (masks_[here] & 8) != 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if ((masks_[here] >> axis & 1) != 0)
    {
      Crossing crossing{ voxel, axis, sites_[here], sites_[here + stride[axis]], inside };
      if (inside_ == nullptr || this->isWanted(crossing))
      {
        crossings_.push_back(crossing);
      }
    }
  }
}

} // namespace medial
