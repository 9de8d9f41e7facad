#pragma once

#include <vtkBoundingBox.h>

#include <initializer_list>

class vtkCamera;
class vtkPolyData;
class vtkRenderer;

namespace medial::app
{

/// What is left free at the edges of a picture, as shares of its width and height, in [0, 1).
struct Margins
{
  double right = 0.0;
  double top = 0.0;
  double bottom = 0.0;
};

/// Adds the visible points of a mesh: those of cells, or all points of a mesh without cells.
void addSeenPoints(vtkPolyData* mesh, vtkBoundingBox& bounds);

///@{
/// Looks in parallel projection along the thinnest axis of the mesh, so that its widest side is in
/// front, from a quarter to the right and from above. Up is y, or z where the mesh is flat along y.
void aimCamera(vtkCamera* camera, vtkPolyData* surface);
void aimCamera(vtkCamera* camera, const vtkBoundingBox& bounds);
///@}

///@{
/// Whether a mesh is so flat that the view along its thinnest axis hides much of its shape.
bool isFlat(vtkPolyData* surface);
/// @param bounds of a mesh; invalid bounds are not flat.
bool isFlat(const vtkBoundingBox& bounds);
///@}

///@{
/// Looks at a flat mesh in parallel projection along its shorter long axis, with the side up that
/// aimCamera() has in front, and from above.
void aimCameraAtEdge(vtkCamera* camera, vtkPolyData* surface);
void aimCameraAtEdge(vtkCamera* camera, const vtkBoundingBox& bounds);
///@}

/// Looks at a mesh in parallel projection against the direction of aimCamera().
void aimCameraFromBehind(vtkCamera* camera, vtkPolyData* surface);

/// Adds the visible points of a mesh in the camera's coordinates.
void addSeenPoints(vtkPolyData* mesh, vtkCamera* camera, vtkBoundingBox& bounds);

/// Moves and scales the view until the bounds fit.
/// @param bounds in the camera's coordinates.
/// @param aspect width of the picture over its height.
void fitView(vtkRenderer* renderer, const vtkBoundingBox& bounds, double aspect,
  const Margins& margins);

/// Moves and scales the view until every point of a cell fits.
/// @param aspect width of the picture over its height.
void fitView(vtkRenderer* renderer, std::initializer_list<vtkPolyData*> meshes, double aspect,
  const Margins& margins);

} // namespace medial::app
