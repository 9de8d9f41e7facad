#include "scalar_bar.h"

#include <vtkScalarsToColors.h>
#include <vtkTextProperty.h>

namespace medial::app
{
namespace
{

void setText(vtkTextProperty* text, int fontSize)
{
  text->SetColor(0.15, 0.17, 0.2);
  text->SetFontSize(fontSize);
  text->ItalicOff();
  text->BoldOff();
  text->ShadowOff();
}

} // namespace

vtkSmartPointer<vtkScalarBarActor> makeScalarBar(vtkScalarsToColors* colours, const char* title,
  int fontSize, const char* nameOfNone)
{
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(colours);
  bar->SetTitle(title);
  if (nameOfNone != nullptr)
  {
    bar->DrawNanAnnotationOn();
    bar->SetNanAnnotation(nameOfNone);
    bar->FixedAnnotationLeaderLineColorOff();
    setText(bar->GetAnnotationTextProperty(), fontSize * 6 / 7);
  }
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.3g");
  bar->SetMaximumNumberOfColors(256);
  bar->SetVerticalTitleSeparation(fontSize * 6 / 7);
  bar->SetTextPad(8);
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(1.0 - kBarShare, 0.2);
  bar->SetWidth(kBarShare * 0.8);
  bar->SetHeight(0.6);
  bar->SetBarRatio(0.25);
  setText(bar->GetTitleTextProperty(), fontSize);
  setText(bar->GetLabelTextProperty(), fontSize);
  return bar;
}

} // namespace medial::app
