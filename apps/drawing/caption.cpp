#include "caption.h"

#include <vtkCoordinate.h>
#include <vtkTextProperty.h>
#include <vtk_utf8.h>

#include <iterator>

namespace medial::app
{
namespace
{

constexpr int kFontSize = 30;

// What is too long keeps its end, which tells names of files apart.
std::string fittingText(const std::string& text)
{
  if (text.size() <= kMaxCharacters)
  {
    return text;
  }
  std::size_t start = text.size() - kMaxCharacters;
  while (start < text.size() && (static_cast<unsigned char>(text[start]) & 0xc0U) == 0x80U)
  {
    ++start; // within a character of UTF-8
  }
  return "..." + text.substr(start);
}

} // namespace

double shareOfLines(std::size_t count)
{
  return static_cast<double>(count) * kLineShare + 2.0 * kTextMargin;
}

std::string drawableText(const std::string& text)
{
  std::string valid;
  utf8::replace_invalid(text.begin(), text.end(), std::back_inserter(valid), U'?');
  return valid;
}

vtkSmartPointer<vtkTextActor> makeLine(const std::string& text, double height, const Colour& colour)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(drawableText(fittingText(text)).c_str());
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(kTextMargin, height);
  vtkTextProperty* look = actor->GetTextProperty();
  look->SetColor(colour[0], colour[1], colour[2]);
  look->SetFontSize(kFontSize);
  return actor;
}

} // namespace medial::app
