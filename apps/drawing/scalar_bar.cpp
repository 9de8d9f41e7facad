#include "scalar_bar.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkScalarsToColors.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <cstdio>

namespace medial::app
{
namespace
{

constexpr int kMaxSteps = 5;
constexpr const char* kTickFormat = "%.3g";
// The bar as a share of the picture.
constexpr double kLeft = 1.0 - kBarShare;
constexpr double kBottom = 0.2;
constexpr double kWidth = kBarShare * 0.8;
constexpr double kBarRatio = 0.25;

void setText(vtkTextProperty* text, int fontSize)
{
  text->SetColor(0.15, 0.17, 0.2);
  text->SetFontSize(fontSize);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}

// The least round step of which at most kMaxSteps fit.
double roundStep(double max)
{
  const double least = max / kMaxSteps;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : { 1.0, 2.0, 2.5, 5.0 })
  {
    if (factor * power >= least)
    {
      return factor * power;
    }
  }
  return 10.0 * power;
}

} // namespace

std::vector<double> scaleTicks(double max)
{
  std::vector<double> ticks{ 0.0 };
  if (!(max > 0.0) || !std::isfinite(max))
  {
    return ticks;
  }
  const double step = roundStep(max);
  constexpr double kRoom = 0.3; // for the maximum's number, in steps
  for (int i = 1; i * step <= max - kRoom * step; ++i)
  {
    ticks.push_back(i * step);
  }
  ticks.push_back(max);
  return ticks;
}

std::string tickText(double tick)
{
  char text[32];
  std::snprintf(text, sizeof(text), kTickFormat, tick);
  return text;
}

vtkSmartPointer<vtkScalarBarActor> makeScalarBar(vtkScalarsToColors* colours, const char* title,
  int fontSize)
{
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colours);
  bar->SetTitle(title);
  bar->SetLabelFormat(kTickFormat);
  bar->SetMaximumNumberOfColors(256);
  bar->SetVerticalTitleSeparation(fontSize * 6 / 7);
  bar->SetTextPad(8);
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(kLeft, kBottom);
  bar->SetWidth(kWidth);
  bar->SetHeight(0.6);
  bar->SetBarRatio(kBarRatio);
  setText(bar->GetTitleTextProperty(), fontSize);
  setText(bar->GetLabelTextProperty(), fontSize);
  return bar;
}

void setTicks(vtkScalarBarActor* bar, double max, bool isSigned)
{
  vtkNew<vtkDoubleArray> labels;
  for (const double tick : scaleTicks(max))
  {
    labels->InsertNextValue(tick);
    if (isSigned && tick > 0.0)
    {
      labels->InsertNextValue(-tick);
    }
  }
  bar->SetCustomLabels(labels);
  bar->UseCustomLabelsOn();
}

NoneKey makeNoneKey(const double colour[3], const char* name, int fontSize)
{
  constexpr double kFrame = 0.004; // between a scalar bar's position and its colours
  constexpr double kRight = kLeft + kWidth * kBarRatio;
  constexpr double kTop = kBottom - 0.03;
  constexpr double kHeight = 0.03;
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(kLeft + kFrame, kTop - kHeight, 0.0);
  corners->InsertNextPoint(kRight, kTop - kHeight, 0.0);
  corners->InsertNextPoint(kRight, kTop, 0.0);
  corners->InsertNextPoint(kLeft + kFrame, kTop, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> rectangle;
  rectangle->SetPoints(corners);
  rectangle->SetPolys(cells);
  vtkNew<vtkCoordinate> shares;
  shares->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(rectangle);
  mapper->SetTransformCoordinate(shares);
  NoneKey key{ vtkSmartPointer<vtkActor2D>::New(), vtkSmartPointer<vtkTextActor>::New() };
  key.swatch->SetMapper(mapper);
  key.swatch->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  key.name->SetInput(name);
  key.name->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  key.name->SetPosition(kRight + 0.01, kTop - 0.5 * kHeight);
  setText(key.name->GetTextProperty(), fontSize);
  key.name->GetTextProperty()->SetVerticalJustificationToCentered();
  return key;
}

} // namespace medial::app
