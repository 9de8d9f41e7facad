#include "input/vtp_file.h"

#include "files/vtp_reader.h"
#include "input/input_file.h"

namespace medial::app
{

vtkSmartPointer<vtkPolyData> readVtp(const std::filesystem::path& path)
{
  vtkSmartPointer<vtkPolyData> mesh;
  withReaderFailures(path, [&] { mesh = files::readVtp(path); });
  return mesh;
}

} // namespace medial::app
