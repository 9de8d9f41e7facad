#include "vtkMedialThickness.h"

#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMeshConversion.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "medial/thickness.h"

vtkStandardNewMacro(vtkMedialThickness);

//------------------------------------------------------------------------------
vtkMedialThickness::vtkMedialThickness() = default;

//------------------------------------------------------------------------------
vtkMedialThickness::~vtkMedialThickness() = default;

//------------------------------------------------------------------------------
const char* vtkMedialThickness::GetSideAsString()
{
  return vtkSideAsString(this->Side);
}

//------------------------------------------------------------------------------
void vtkMedialThickness::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkPolyData* input = inputs[0];
  vtkPolyData* output = outputs[0];
  vtkProgressBridge progress(this);
  medial::ThicknessOptions options;
  options.angle = this->Angle;
  options.side = vtkToSide(this->Side);
  options.execution = vtkToExecution(this->NumberOfThreads, progress);
  const medial::TriangleMesh mesh =
    medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(input));
  const medial::Thickness thickness = medial::computeThickness(mesh, options);
  output->ShallowCopy(input);
  vtkMeshConversion::AddThickness(thickness, mesh, output);
  vtkMedialFigures figures(output);
  figures.AddNumber("MinThickness", thickness.min);
  figures.AddNumber("MedianThickness", thickness.median);
  figures.AddNumber("MaxThickness", thickness.max);
  figures.AddNumber("ShareWithout", thickness.shareWithout());
}

//------------------------------------------------------------------------------
void vtkMedialThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "Side: " << this->GetSideAsString() << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
