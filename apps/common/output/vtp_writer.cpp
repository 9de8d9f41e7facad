#include "output/vtp_writer.h"

#include "failure.h"
#include "vtk_messages.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace medial::app
{

void writeVtp(vtkPolyData* data, const std::filesystem::path& file)
{
  const VtkMessages messages; // errors are in the error code
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
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

} // namespace medial::app
