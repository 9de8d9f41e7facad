#pragma once

#include <vtkActor2D.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <string>
#include <vector>

class vtkScalarsToColors;

namespace medial::app
{

/// Share of a picture's width that a scalar bar takes, on its right.
constexpr double kBarShare = 0.16;

/// Numbers for a scale from 0 to a maximum: both ends, and between them the multiples of 1, 2, 2.5
/// or 5 times a power of ten that have room, in ascending order.
/// @param max if it is not positive and finite, 0 is the only number.
std::vector<double> scaleTicks(double max);

/// The number as scales write it.
std::string tickText(double tick);

/// A scalar bar for the right margin of a picture on white. setTicks() gives it numbers.
/// @param fontSize of the title and numbers, in pixels.
vtkSmartPointer<vtkScalarBarActor> makeScalarBar(vtkScalarsToColors* colours, const char* title,
  int fontSize);

/// Writes scaleTicks() along a scalar bar.
/// @param max of the bar's colours.
/// @param isSigned whether the colours begin at -`max`: the ticks stand below 0, too.
void setTicks(vtkScalarBarActor* bar, double max, bool isSigned = false);

/// What stands below a scalar bar for places without a value.
struct NoneKey
{
  vtkSmartPointer<vtkActor2D> swatch;
  vtkSmartPointer<vtkTextActor> name; ///< beside the swatch
};

/// @param colour of the swatch: red, green and blue in [0, 1].
NoneKey makeNoneKey(const double colour[3], const char* name, int fontSize);

} // namespace medial::app
