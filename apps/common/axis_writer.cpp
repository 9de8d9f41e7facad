#include "axis_writer.h"

#include "axis_formats.h"
#include "failure.h"
#include "text_cursor.h"
#include "vtk_messages.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <functional>
#include <map>
#include <string>

namespace fs = std::filesystem;

namespace medial::app
{

void writeVtp(vtkPolyData* surface, const fs::path& file)
{
  const VtkMessages messages; // what goes wrong is in the error code
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(surface);
  writer->SetFileName(file.c_str());
  writer->EncodeAppendedDataOff();
  // Writing an axis by zlib takes a quarter of a whole run; LZ4's files are a third larger.
  writer->SetCompressorTypeToLZ4();
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    throw Failure(ExitCode::NoSpace, vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
}

void writeAxis(vtkPolyData* axis, const fs::path& file, const fs::path& extension)
{
  static const std::map<std::string, std::function<void(vtkPolyData*, const fs::path&)>>
    kWriters = {
      { ".vtp", writeVtp },
      { ".ply", writePly },
      { ".obj", writeObj },
      { ".ma", writeMa },
    };
  kWriters.at(lowerCase(extension.string()))(axis, file);
}

} // namespace medial::app
