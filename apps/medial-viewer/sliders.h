#pragma once

#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkSmartPointer.h>

#include <functional>

class vtkRenderWindowInteractor;

namespace medial::app
{

/// The looks and the range of a slider.
struct SliderStyle
{
  const char* title;
  const char* format; ///< of the value, as printf
  double min;
  double max;
  double left; ///< ends of the slider, as fractions of the window's width
  double right;
};

/// A slider at the bottom of the window.
class Slider
{
public:
  using Act = std::function<void(double value)>;

  Slider(vtkRenderWindowInteractor* interactor, const SliderStyle& style, double value);

  /// Calls `act` with the value at every move.
  void onMove(Act act);
  /// Calls `act` with the value when the button is released.
  void onRelease(Act act);

  double value() { return look_->GetValue(); }
  void setValue(double value) { look_->SetValue(value); }

private:
  void observe(unsigned long event, Act act);

  vtkSmartPointer<vtkSliderRepresentation2D> look_;
  vtkSmartPointer<vtkSliderWidget> widget_;
};

} // namespace medial::app
