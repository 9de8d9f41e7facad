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

constexpr int kColours = 512;
constexpr int kLinesEvery = 32; // colours between two lines of equal distance
constexpr double kLineShade = 0.6;

// From blue through white at 0 to red, darker along the lines.
vtkSmartPointer<vtkLookupTable> makeTable()
{
  vtkNew<vtkColorTransferFunction> colours;
  colours->SetColorSpaceToDiverging();
  colours->AddRGBPoint(0.0, 0.13, 0.35, 0.7);
  colours->AddRGBPoint(0.5, 0.97, 0.97, 0.97);
  colours->AddRGBPoint(1.0, 0.75, 0.3, 0.15);
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(kColours);
  for (int i = 0; i < kColours; ++i)
  {
    double rgb[3];
    colours->GetColor(static_cast<double>(i) / (kColours - 1), rgb);
    const bool line = (i + 1) % kLinesEvery <= 1;
    const double shade = line ? kLineShade : 1.0;
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
  // An opaque texture is drawn right beside translucent surfaces.
  widget_->GetColorMap()->SetOutputFormatToRGB();
  widget_->GetColorMap()->PassAlphaToOutputOff();
  widget_->GetPlaneProperty()->SetColor(0.35, 0.38, 0.42);
  widget_->GetTexturePlaneProperty()->LightingOff();
}

FieldSlice::~FieldSlice()
{
  widget_->Off();
}

void FieldSlice::setField(vtkImageData* field, double greatest)
{
  widget_->GetLookupTable()->SetTableRange(-greatest, greatest);
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
  widget_->GetLookupTable()->SetTableRange(-greatest, greatest);
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
