#include "vtkMedialCurves.h"

#include "medial/axis_curves.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <vector>

vtkStandardNewMacro(vtkMedialCurves);

namespace
{

//------------------------------------------------------------------------------
medial::AxisEdges EdgesOf(vtkPolyData* input)
{
  medial::AxisEdges edges;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType cell = 0; cell < input->GetPolys()->GetNumberOfCells(); ++cell)
  {
    input->GetPolys()->GetCellAtId(cell, count, ids);
    for (vtkIdType i = 0; i < count; ++i)
    {
      edges.sides.push_back({ ids[i], ids[(i + 1) % count] });
    }
  }
  for (vtkIdType cell = 0; cell < input->GetLines()->GetNumberOfCells(); ++cell)
  {
    input->GetLines()->GetCellAtId(cell, count, ids);
    for (vtkIdType i = 0; i + 1 < count; ++i)
    {
      edges.lines.push_back({ ids[i], ids[i + 1] });
    }
  }
  return edges;
}

//------------------------------------------------------------------------------
// Copies the points that are used, with their data, on first use.
class PointCopier
{
public:
  PointCopier(vtkPolyData* input, vtkPolyData* output)
    : Input(input)
    , Output(output)
    , Targets(input->GetNumberOfPoints(), -1)
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(input->GetPoints()->GetDataType());
    output->SetPoints(points);
    output->GetPointData()->CopyAllocate(input->GetPointData());
  }

  vtkIdType Copy(vtkIdType point)
  {
    vtkIdType& target = this->Targets[point];
    if (target < 0)
    {
      target = this->Output->GetPoints()->InsertNextPoint(this->Input->GetPoint(point));
      this->Output->GetPointData()->CopyData(this->Input->GetPointData(), point, target);
    }
    return target;
  }

private:
  vtkPolyData* Input;
  vtkPolyData* Output;
  std::vector<vtkIdType> Targets;
};

} // namespace

//------------------------------------------------------------------------------
int vtkMedialCurves::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const auto wanted = [this](medial::AxisFeature kind)
  {
    return (kind == medial::AxisFeature::Rim && this->Rims) ||
      (kind == medial::AxisFeature::Seam && this->Seams) ||
      (kind == medial::AxisFeature::Curve && this->Curves);
  };
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> kinds;
  kinds->SetName("AxisFeature");
  PointCopier copier(input, output);
  for (const medial::AxisCurve& curve :
    medial::axisCurves(EdgesOf(input), static_cast<std::size_t>(input->GetNumberOfPoints())))
  {
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return 1;
    }
    if (wanted(curve.kind))
    {
      lines->InsertNextCell(static_cast<int>(curve.points.size()));
      for (const vtkIdType point : curve.points)
      {
        lines->InsertCellPoint(copier.Copy(point));
      }
      kinds->InsertNextValue(static_cast<unsigned char>(curve.kind));
    }
  }
  output->SetLines(lines);
  output->GetCellData()->SetScalars(kinds);
  return 1;
}

//------------------------------------------------------------------------------
void vtkMedialCurves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rims: " << (this->Rims ? "On" : "Off") << "\n";
  os << indent << "Seams: " << (this->Seams ? "On" : "Off") << "\n";
  os << indent << "Curves: " << (this->Curves ? "On" : "Off") << "\n";
}
