#pragma once

#include <vector>

class vtkPolyData;

namespace medial::app
{

/// Adds a float32 point data array; Radius becomes the active scalars.
void addPointArray(vtkPolyData* axis, const char* name, const std::vector<double>& values);

/// Makes every point that no cell uses a vertex.
void addLooseVertices(vtkPolyData* axis);

} // namespace medial::app
