#include "input/model_reader.h"

#include "input/input_file.h"
#include "input/vtp_file.h"
#include "library_calls.h"
#include "number_text.h"

#include "medial/axis_io.h"

#include <vtkDataArray.h>
#include <vtkMedialModelConversion.h>
#include <vtkPointData.h>

#include <cmath>
#include <string>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

// Rounds to single precision, whatever precision the file has.
double toRadius(double value)
{
  return static_cast<double>(static_cast<float>(value));
}

void checkBalls(const fs::path& path, vtkPolyData* axis, vtkDataArray* radii)
{
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    const std::string point = "point " + std::to_string(i) + ": ";
    double position[3];
    axis->GetPoint(i, position);
    for (const double coordinate : position)
    {
      if (!std::isfinite(coordinate))
      {
        refuseFile(path, point + "coordinate " + roundedText(coordinate) + " is not finite");
      }
    }
    const double radius = toRadius(radii->GetTuple1(i));
    if (!(radius >= 0.0 && std::isfinite(radius)))
    {
      refuseFile(path, point + "radius " + roundedText(radius) + " is outside [0, infinity)");
    }
  }
}

MedialModel readVtpModel(const fs::path& path)
{
  const vtkSmartPointer<vtkPolyData> axis = readVtp(path);
  vtkDataArray* radii = axis->GetPointData()->GetArray("Radius");
  if (radii == nullptr || radii->GetNumberOfComponents() != 1)
  {
    refuseFile(path, "has no point data array Radius of one component");
  }
  if (axis->GetNumberOfPoints() == 0)
  {
    refuseFile(path, "holds no points");
  }
  checkBalls(path, axis, radii);
  MedialModel model = vtkMedialModelConversion::ToMedialModel(axis);
  for (double& radius : model.radii)
  {
    radius = toRadius(radius);
  }
  return model;
}

} // namespace

MedialModel readModel(const fs::path& path)
{
  requireRegularFile(path);
  MedialModel model;
  if (axisFormatOf(path))
  {
    withFailures([&] { model = toMedialModel(readAxis(path)); });
    withFailures(path, [&] { checkMedialModel(model); });
    return model;
  }
  if (extensionOf(path) != ".vtp")
  {
    refuseFile(path, "unknown extension '" + extensionOf(path) + "', allowed: .vtp .ply .obj .ma");
  }
  withFailures(path, [&] { model = readVtpModel(path); });
  return model;
}

} // namespace medial::app
