#include "sliders.h"

#include "event_call.h"

#include <vtkCommand.h>
#include <vtkCoordinate.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkTextProperty.h>

#include <utility>

namespace medial::app
{
namespace
{

constexpr double kHeight = 0.07;  // of the slider over the lower border, fraction of the window
constexpr float kPriority = 0.7F; // before the slice, which may lie behind it

vtkSmartPointer<vtkSliderRepresentation2D> makeLook(const SliderStyle& style)
{
  auto look = vtkSmartPointer<vtkSliderRepresentation2D>::New();
  look->SetMinimumValue(style.min);
  look->SetMaximumValue(style.max);
  look->SetTitleText(style.title);
  look->SetLabelFormat(style.format);
  look->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  look->GetPoint1Coordinate()->SetValue(style.left, kHeight);
  look->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  look->GetPoint2Coordinate()->SetValue(style.right, kHeight);
  look->SetSliderLength(0.015);
  look->SetSliderWidth(0.025);
  look->SetTubeWidth(0.006);
  look->SetEndCapLength(0.005);
  look->SetTitleHeight(0.022);
  look->SetLabelHeight(0.022);
  for (vtkTextProperty* text : { look->GetTitleProperty(), look->GetLabelProperty() })
  {
    text->SetColor(0.15, 0.17, 0.2);
    text->BoldOff();
    text->ItalicOff();
    text->ShadowOff();
  }
  look->GetTubeProperty()->SetColor(0.7, 0.73, 0.78);
  look->GetCapProperty()->SetColor(0.7, 0.73, 0.78);
  look->GetSliderProperty()->SetColor(0.2, 0.45, 0.65);
  look->GetSelectedProperty()->SetColor(0.85, 0.45, 0.15);
  return look;
}

} // namespace

Slider::Slider(vtkRenderWindowInteractor* interactor, const SliderStyle& style, double value)
  : look_(makeLook(style))
  , widget_(vtkSmartPointer<vtkSliderWidget>::New())
{
  look_->SetValue(value);
  widget_->SetInteractor(interactor);
  widget_->SetRepresentation(look_);
  widget_->SetAnimationModeToJump();
  widget_->KeyPressActivationOff();
  widget_->SetPriority(kPriority);
  widget_->EnabledOn();
}

void Slider::onMove(Act act)
{
  observe(vtkCommand::InteractionEvent, std::move(act));
}

void Slider::onRelease(Act act)
{
  observe(vtkCommand::EndInteractionEvent, std::move(act));
}

void Slider::observe(unsigned long event, Act act)
{
  observeEvent(widget_, event,
    [look = look_.Get(), act = std::move(act)] { act(look->GetValue()); });
}

} // namespace medial::app
