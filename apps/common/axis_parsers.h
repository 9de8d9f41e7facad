#pragma once

#include <string>

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace medial::app
{

/// The formats that readAxis() reads without VTK, from the whole file's content.
/// @throws Failure BadInput as readAxis(), without the file's name.
vtkSmartPointer<vtkPolyData> parseAxisPly(const std::string& content);
vtkSmartPointer<vtkPolyData> parseAxisObj(const std::string& content);
vtkSmartPointer<vtkPolyData> parseMa(const std::string& content);

} // namespace medial::app
