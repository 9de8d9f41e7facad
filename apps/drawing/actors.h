#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

class vtkPolyData;
class vtkScalarsToColors;

namespace medial::app
{

// Each follows its data, when that is modified, at the next drawing.

/// A translucent grey surface, smooth but for its sharp edges.
vtkSmartPointer<vtkActor> makeSurface(vtkPolyData* surface);

/// The edges at which faces meet at an angle.
vtkSmartPointer<vtkActor> makeSharpEdges(vtkPolyData* surface);

/// A medial axis coloured by one of its point arrays.
vtkSmartPointer<vtkActor> makeAxis(vtkPolyData* axis, vtkScalarsToColors* colours,
  const char* array);

} // namespace medial::app
