#pragma once

#include "medial/grid.h"

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

class vtkPolyData;

namespace medial::app
{

/// A region of a surface beyond a limit.
struct PictureRegion
{
  Point3 place{};  ///< where its number is drawn
  Point3 normal{}; ///< the mean of its triangles, outwards, of any length
};

/// Regions of a surface beyond limits.
struct PictureRegions
{
  vtkSmartPointer<vtkPolyData> triangles; ///< null if there are none
  std::vector<PictureRegion> first;       ///< the first ones, in the order of their numbers
};

/// Draws a surface coloured by its Thickness, from 0 to its maximum, grey where there is none, with
/// a caption and a scalar bar in world units, as a PNG file of 1600 x 1200 pixels. Needs no
/// display.
/// @param coloured has the array, and enough points to show how it varies.
/// @param surface of the same shape, whose sharp edges are drawn.
/// @param regions drawn in red, with their numbers, from 1. If some of the first face away, a
///   second view from behind has their numbers.
/// @throws Failure NoGpu if there is no OpenGL, NoSpace if the file cannot be written completely.
///   The message does not name it.
void drawThickness(vtkPolyData* coloured, vtkPolyData* surface, const PictureRegions& regions,
  const std::vector<std::string>& caption, const std::filesystem::path& file);

} // namespace medial::app
