#pragma once

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

class vtkPolyData;
class vtkScalarsToColors;

namespace medial::app
{

// Each actor shows changes of its data the next time it is drawn.

/// A surface and its outline, either of which may be left out.
struct SurfaceActors
{
  vtkSmartPointer<vtkActor> faces; ///< translucent and grey, smooth but for the sharp edges
  vtkSmartPointer<vtkActor> edges; ///< those at which faces meet at an angle
};

SurfaceActors makeSurface(vtkPolyData* surface);

/// A surface, or points, coloured by a point array, flat and little shaded.
vtkSmartPointer<vtkActor> makeColoured(vtkPolyData* surface, vtkScalarsToColors* colours,
  const char* array);

/// A skeleton as tubes coloured by radius, and its ends and junctions as dots.
struct SkeletonActors
{
  vtkSmartPointer<vtkActor> branches;
  vtkSmartPointer<vtkActor> ends;
};

SkeletonActors makeSkeleton(vtkPolyData* skeleton, vtkScalarsToColors* colours);

/// The edges that belong to one face only, as lines.
vtkSmartPointer<vtkAlgorithm> makeBorderLines(vtkPolyData* faces);

/// The branches of a skeleton as tubes, with its point arrays.
vtkSmartPointer<vtkPolyData> tubesOf(vtkPolyData* skeleton, int sides);
/// The points of a skeleton where no branch goes on, as vertices among all of its points.
vtkSmartPointer<vtkPolyData> endsOf(vtkPolyData* skeleton);

/// A medial axis coloured by one of its point arrays. Rims of sheets are lines as well, so that no
/// sheet vanishes that is narrow or seen from its edge.
vtkSmartPointer<vtkActor> makeAxis(vtkPolyData* axis, vtkScalarsToColors* colours,
  const char* array);

} // namespace medial::app
