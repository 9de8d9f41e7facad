// Reads a surface, computes its medial axis and writes it: medial_pipeline INPUT.stl OUTPUT.vtp
#include <vtkAbstractArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkMedialAxis.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkVariant.h>
#include <vtkXMLPolyDataWriter.h>

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: " << argv[0] << " INPUT.stl OUTPUT.vtp\n";
    return 2;
  }
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkMedialAxis> axis;
  axis->SetInputConnection(reader->GetOutputPort());
  axis->SetResolution(64);
  axis->SetAngle(60.0);
  // If the reader fails, the axis is not executed and has no error code. Some readers have none
  // either.
  if (axis->GetExecutive()->Update() == 0 || axis->GetErrorCode() != 0)
  {
    return 1; // VTK has printed the cause
  }

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(axis->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->Write(); // returns 1 even if it cannot open the file
  if (writer->GetErrorCode() != 0)
  {
    return 1;
  }
  // The field data tell how an output was made.
  vtkFieldData* figures = axis->GetOutput()->GetFieldData();
  std::cout << axis->GetOutput()->GetNumberOfCells() << " cells, computed by the engine "
            << figures->GetAbstractArray("Engine")->GetVariantValue(0).ToString() << "\n";
}
