#pragma once

#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <cstddef>
#include <string>

// Lines of text at the left edge of a picture of 1600 x 1200 pixels.
namespace medial::app
{

using Colour = std::array<double, 3>; ///< red, green and blue in [0, 1]

/// Height of a line of text as a share of the picture's.
constexpr double kLineShare = 0.036;
/// What is left free around text, as a share of the picture's width or height.
constexpr double kTextMargin = 0.02;

/// A picture is wide enough for a line of so many.
constexpr std::size_t kMaxCharacters = 88;

/// What some lines and their margins take of the picture's height.
double shareOfLines(std::size_t count);

/// A text that VTK draws: where a name of a file is not UTF-8 it would draw nothing at all.
std::string drawableText(const std::string& text);

/// A line of text; of one that is too long for the picture, its end.
/// @param height of the line's lower edge, as a share of that of the picture.
vtkSmartPointer<vtkTextActor> makeLine(const std::string& text, double height,
  const Colour& colour);

} // namespace medial::app
