#include "field_slice.h"

#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkImageMapToColors.h>
#include <vtkLookupTable.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>

namespace medial::app
{
namespace
{

constexpr int kBands = 32;
constexpr double kBandShade = 0.9; // of every other band

// From blue through white at 0 to red, in bands whose borders are lines of equal distance.
vtkSmartPointer<vtkLookupTable> makeTable()
{
  vtkNew<vtkColorTransferFunction> colours;
  colours->SetColorSpaceToDiverging();
  colours->AddRGBPoint(0.0, 0.2, 0.42, 0.75);
  colours->AddRGBPoint(0.5, 0.97, 0.97, 0.97);
  colours->AddRGBPoint(1.0, 0.85, 0.5, 0.35);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kBands);
  for (int i = 0; i < kBands; ++i)
  {
    double rgb[3];
    colours->GetColor(static_cast<double>(i) / (kBands - 1), rgb);
    const double shade = i % 2 == 0 ? 1.0 : kBandShade;
    table->SetTableValue(i, shade * rgb[0], shade * rgb[1], shade * rgb[2], 1.0);
  }
  return table;
}

} // namespace

FieldSlice::FieldSlice(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer)
{
  widget_->SetInteractor(interactor);
  widget_->SetDefaultRenderer(renderer);
  widget_->SetCurrentRenderer(renderer);
  widget_->KeyPressActivationOff();
  widget_->SetLeftButtonAction(vtkImagePlaneWidget::VTK_SLICE_MOTION_ACTION);
  widget_->SetMiddleButtonAction(vtkImagePlaneWidget::VTK_CURSOR_ACTION);
  widget_->DisplayTextOff();
  widget_->RestrictPlaneToVolumeOn();
  widget_->SetResliceInterpolateToLinear();
  widget_->UserControlledLookupTableOn();
  widget_->SetLookupTable(makeTable());
  // Together with translucent surfaces VTK draws only an opaque texture correctly.
  widget_->GetColorMap()->SetOutputFormatToRGB();
  widget_->GetColorMap()->PassAlphaToOutputOff();
  widget_->GetPlaneProperty()->SetColor(0.35, 0.38, 0.42);
  widget_->GetTexturePlaneProperty()->LightingOff();
}

FieldSlice::~FieldSlice()
{
  widget_->Off();
}

void FieldSlice::setField(vtkImageData* field, double max)
{
  widget_->GetLookupTable()->SetTableRange(-max, max);
  const int* now = field->GetDimensions();
  if (std::equal(now, now + 3, dimensions_))
  {
    return; // the same image; the widget draws its new values
  }
  const bool first = dimensions_[0] == 0;
  std::array<std::array<double, 3>, 3> corners{};
  widget_->GetOrigin(corners[0].data());
  widget_->GetPoint1(corners[1].data());
  widget_->GetPoint2(corners[2].data());

  std::copy(now, now + 3, dimensions_);
  source_->SetOutput(field);
  widget_->SetInputConnection(source_->GetOutputPort());
  if (first)
  {
    setNormal(2);
  }
  else
  {
    widget_->SetOrigin(corners[0].data());
    widget_->SetPoint1(corners[1].data());
    widget_->SetPoint2(corners[2].data());
    widget_->UpdatePlacement();
  }
  widget_->GetLookupTable()->SetTableRange(-max, max);
}

void FieldSlice::setVisible(bool visible)
{
  widget_->SetEnabled(visible ? 1 : 0);
}

void FieldSlice::setNormal(int axis)
{
  widget_->SetPlaneOrientation(axis);
  widget_->SetSliceIndex(dimensions_[axis] / 2);
}

} // namespace medial::app
