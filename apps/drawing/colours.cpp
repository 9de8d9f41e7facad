#include "colours.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <array>

namespace medial::app
{
namespace
{

// Control points of the perceptually uniform map "viridis", from the smallest value to the
// largest.
constexpr std::array<std::array<double, 3>, 9> kViridis = { { { 0.267, 0.005, 0.329 },
  { 0.279, 0.175, 0.483 }, { 0.230, 0.322, 0.546 }, { 0.173, 0.449, 0.558 },
  { 0.128, 0.567, 0.551 }, { 0.158, 0.684, 0.502 }, { 0.369, 0.789, 0.383 },
  { 0.678, 0.864, 0.190 }, { 0.993, 0.906, 0.144 } } };

} // namespace

void setColours(vtkColorTransferFunction* colours, double max)
{
  colours->RemoveAllPoints();
  for (std::size_t i = 0; i < kViridis.size(); ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(kViridis.size() - 1);
    const auto& rgb = kViridis[i];
    colours->AddRGBPoint(t * max, rgb[0], rgb[1], rgb[2]);
  }
}

vtkSmartPointer<vtkColorTransferFunction> makeColours(double max)
{
  auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  setColours(colours, max);
  return colours;
}

vtkSmartPointer<vtkColorTransferFunction> makeSignedColours(double max)
{
  auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  colours->SetColorSpaceToDiverging();
  colours->AddRGBPoint(-max, 0.230, 0.299, 0.754);
  colours->AddRGBPoint(0.0, 0.865, 0.865, 0.865);
  colours->AddRGBPoint(max, 0.706, 0.016, 0.150);
  return colours;
}

double maxRadius(vtkPolyData* axis)
{
  return axis->GetNumberOfPoints() > 0 ? axis->GetPointData()->GetArray("Radius")->GetRange()[1]
                                       : 0.0;
}

double scaleEnd(double max)
{
  return max > 0.0 ? max : 1.0;
}

} // namespace medial::app
