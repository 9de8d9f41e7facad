#include "input/vtp_file.h"

#include "files/vtp_reader.h"
#include "input/input_file.h"
#include "library_calls.h"
#include "vtk_messages.h"

namespace medial::app
{

vtkSmartPointer<vtkPolyData> readVtp(const std::filesystem::path& path)
{
  const VtkMessages messages;
  vtkSmartPointer<vtkPolyData> mesh;
  withFailures([&] { mesh = files::readVtp(path); });
  if (!messages.first().empty())
  {
    refuseFile(path, messages.first());
  }
  return mesh;
}

} // namespace medial::app
