#include "axis_reader.h"

#include "axis_parsers.h"
#include "failure.h"
#include "mesh_reader.h"
#include "soup_builder.h"
#include "text_cursor.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <cmath>
#include <functional>
#include <map>
#include <sstream>
#include <string>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

std::string text(double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

void checkBalls(vtkPolyData* axis)
{
  vtkDataArray* radius = axis->GetPointData()->GetArray("Radius");
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    const std::string point = "point " + std::to_string(i) + ": ";
    double position[3];
    axis->GetPoint(i, position);
    for (const double coordinate : position)
    {
      if (!std::isfinite(coordinate))
      {
        refuse(point + "coordinate " + text(coordinate) + " is not finite");
      }
    }
    const double r = radius->GetTuple1(i);
    if (!(r >= 0.0 && std::isfinite(r)))
    {
      refuse(point + "radius " + text(r) + " is outside [0, infinity)");
    }
  }
}

// Points and radii as this program keeps them, whatever the file had.
vtkSmartPointer<vtkPolyData> normalised(vtkPolyData* read)
{
  vtkDataArray* radius = read->GetPointData()->GetArray("Radius");
  if (radius == nullptr || radius->GetNumberOfComponents() != 1)
  {
    refuse("has no point data array Radius of one component");
  }
  auto axis = vtkSmartPointer<vtkPolyData>::New();
  axis->ShallowCopy(read);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (read->GetPoints() != nullptr)
  {
    points->DeepCopy(read->GetPoints());
  }
  axis->SetPoints(points);
  vtkNew<vtkFloatArray> values;
  values->DeepCopy(radius);
  values->SetName("Radius");
  axis->GetPointData()->AddArray(values);
  axis->GetPointData()->SetActiveScalars("Radius");
  return axis;
}

vtkSmartPointer<vtkPolyData> readVtpAxis(const fs::path& path)
{
  return normalised(readVtp(path));
}

using Read = std::function<vtkSmartPointer<vtkPolyData>(const fs::path&)>;

const Read& readerFor(const fs::path& path)
{
  static const std::map<std::string, Read> kReaders = {
    { ".vtp", readVtpAxis },
    { ".ply", [](const fs::path& file) { return parseAxisPly(readWholeFile(file)); } },
    { ".obj", [](const fs::path& file) { return parseAxisObj(readWholeFile(file)); } },
    { ".ma", [](const fs::path& file) { return parseMa(readWholeFile(file)); } },
  };
  const std::string extension = lowerCase(path.extension().string());
  const auto found = kReaders.find(extension);
  if (found == kReaders.end())
  {
    refuse("unknown extension '" + extension + "', allowed: .vtp .ply .obj .ma");
  }
  return found->second;
}

} // namespace

vtkSmartPointer<vtkPolyData> readAxis(const fs::path& path)
{
  const auto read = [](const fs::path& file)
  {
    vtkSmartPointer<vtkPolyData> axis = readerFor(file)(file);
    if (axis->GetNumberOfPoints() == 0)
    {
      refuse("holds no points");
    }
    checkBalls(axis);
    return axis;
  };
  return readFileWith(path, read);
}

} // namespace medial::app
