#pragma once

#include <vtkColorTransferFunction.h>
#include <vtkSmartPointer.h>

class vtkPolyData;

namespace medial::app
{

/// Sets the perceptually uniform map "viridis" from 0 to `max`.
void setColours(vtkColorTransferFunction* colours, double max);

/// The perceptually uniform map "viridis" from 0 to `max`.
vtkSmartPointer<vtkColorTransferFunction> makeColours(double max);

/// Moreland's diverging map "cool to warm" (2009) from -`max`, blue, by grey at 0 to `max`, red.
vtkSmartPointer<vtkColorTransferFunction> makeSignedColours(double max);

/// The largest radius of a medial axis, world units; 0 where it is empty.
double maxRadius(vtkPolyData* axis);

/// Where a scale from 0 ends: at the largest value, or at 1 if no value is above 0.
double scaleEnd(double max);

/// Where the scale of separation angles ends, degrees.
constexpr double kAngleScaleEnd = 180.0;

} // namespace medial::app
