#pragma once

#include <vtkColorTransferFunction.h>
#include <vtkSmartPointer.h>

namespace medial::app
{

/// Sets the perceptually uniform map "viridis" from 0 to `greatest`.
void setColours(vtkColorTransferFunction* colours, double greatest);

/// The perceptually uniform map "viridis" from 0 to `greatest`.
vtkSmartPointer<vtkColorTransferFunction> makeColours(double greatest);

} // namespace medial::app
