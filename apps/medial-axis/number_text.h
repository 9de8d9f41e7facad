#pragma once

#include "medial/grid.h"

#include <charconv>
#include <string>

namespace medial::app
{

/// The shortest text that reads back without loss, in every locale.
inline std::string numberText(double number)
{
  char text[32];
  return { text, std::to_chars(text, text + sizeof(text), number).ptr };
}

/// The coordinates with blanks between them.
inline std::string pointText(const Point3& point)
{
  return numberText(point[0]) + ' ' + numberText(point[1]) + ' ' + numberText(point[2]);
}

} // namespace medial::app
