#include "thinning/voxel_surface.h"

#include "thinning/cubical_complex.h"

namespace medial
{
namespace
{

/// Returns the cells that a voxel shares with the one at an offset from it.
SurfaceCells sharedWith(const glm::ivec3& offset)
{
  SurfaceCells cells = 0;
  const auto touches = [&](int corner, int axis)
  { return offset[axis] == 0 || (offset[axis] > 0) == ((corner >> axis & 1) != 0); };
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<bool, 3> touched{ touches(corner, 0), touches(corner, 1), touches(corner, 2) };
    cells |= touched[0] && touched[1] && touched[2] ? SurfaceCells{ 1 } << corner : 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool low = (corner >> axis & 1) == 0;
      if (low && offset[axis] == 0 && touched[(axis + 1) % 3] && touched[(axis + 2) % 3])
      {
        cells |= SurfaceCells{ 1 } << (kFirstEdges + 8 * axis + corner);
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    if (offset[axis] != 0 && offset[(axis + 1) % 3] == 0 && offset[(axis + 2) % 3] == 0)
    {
      cells |= SurfaceCells{ 1 } << (kFirstFaces + 2 * axis + (offset[axis] > 0 ? 1 : 0));
    }
  }
  return cells;
}

/// Returns the cell of a kind at a corner; nothing if it is not one of the voxel.
SurfaceCells cellAt(int corner, int kind)
{
  const auto spans = static_cast<int>(CubicalComplex::spans(kind));
  if ((corner & spans) != 0)
  {
    return 0;
  }
  switch (CubicalComplex::dimension(kind))
  {
    case 0:
      return SurfaceCells{ 1 } << corner;
    case 1:
      return SurfaceCells{ 1 } << (kFirstEdges + 8 * (kind - kEdgeKind) + corner);
    default:
      return SurfaceCells{ 1 } << (kFirstFaces + 2 * (kind - kFaceKind) + (corner != 0 ? 1 : 0));
  }
}

} // namespace

SharedCells::SharedCells()
{
  for (std::size_t layer = 0; layer < layers_.size(); ++layer)
  {
    for (std::size_t voxels = 0; voxels < layers_[layer].size(); ++voxels)
    {
      for (int i = 0; i < 9; ++i)
      {
        const int around = 9 * static_cast<int>(layer) + i;
        layers_[layer][voxels] |=
          (voxels >> i & 1) != 0 && around != kCentre ? sharedWith(offsetOf(around)) : 0;
      }
    }
  }
}

const SharedCells& sharedCells()
{
  static const SharedCells cells;
  return cells;
}

CellsAtCorners::CellsAtCorners()
{
  for (int corner = 0; corner < 8; ++corner)
  {
    for (std::size_t bits = 0; bits < 256; ++bits)
    {
      SurfaceCells& cells = cells_[corner][bits];
      for (int kind = 0; kind < kVoxelKind; ++kind)
      {
        cells |= (bits >> kind & 1) != 0 ? cellAt(corner, kind) : 0;
      }
    }
  }
}

const CellsAtCorners& cellsAtCorners()
{
  static const CellsAtCorners cells;
  return cells;
}

} // namespace medial
