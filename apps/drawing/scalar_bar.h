#pragma once

#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>

class vtkScalarsToColors;

namespace medial::app
{

/// Share of a picture's width that a scalar bar takes, on its right.
constexpr double kBarShare = 0.16;

/// A scalar bar for the right margin of a picture on white.
/// @param fontSize of the title and numbers, in pixels.
/// @param nameOfNone label for places without a value; null if all have one.
vtkSmartPointer<vtkScalarBarActor> makeScalarBar(vtkScalarsToColors* colours, const char* title,
  int fontSize, const char* nameOfNone = nullptr);

} // namespace medial::app
