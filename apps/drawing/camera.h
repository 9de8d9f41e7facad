#pragma once

#include <initializer_list>

class vtkCamera;
class vtkPolyData;
class vtkRenderer;

namespace medial::app
{

/// Looks in parallel projection along the thinnest axis of the mesh, so that its widest side is in
/// front, from a quarter to the right and from above. Up is y, or z where the mesh is flat along y.
void aimCamera(vtkCamera* camera, vtkPolyData* surface);

/// Moves and scales the view until every point of a cell fits, on the left of a scalar bar.
/// @param aspect width of the picture over its height.
/// @param barShare share of the width that the bar takes, in [0, 1).
void fitView(vtkRenderer* renderer, std::initializer_list<vtkPolyData*> meshes, double aspect,
  double barShare);

} // namespace medial::app
