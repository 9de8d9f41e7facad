#include "input/model_reader.h"

#include "files/extensions.h"
#include "input/input_file.h"
#include "input/vtp_file.h"
#include "library_calls.h"

#include "medial/axis_io.h"

#include <vtkDataArray.h>
#include <vtkMedialModelConversion.h>
#include <vtkPointData.h>

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
  }
  else if (extensionOf(path) == ".vtp")
  {
    withFailures(path, [&] { model = readVtpModel(path); });
  }
  else
  {
    refuseFile(path, files::unknownExtension(path, { ".vtp", ".ply", ".obj", ".ma" }));
  }
  withFailures(path, [&] { checkMedialModel(model); });
  return model;
}

} // namespace medial::app
