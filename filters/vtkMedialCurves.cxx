#include "vtkMedialCurves.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkMedialCells.h"
#include "vtkMedialProgress.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include "medial/axis_curves.h"
#include "medial/error.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMedialCurves);

namespace
{

/// The progress when edges are collected, and when curves are found.
constexpr double EdgesShare = 0.2;
constexpr double SearchShare = 0.8;

constexpr std::size_t CopyingSteps = 20;

//------------------------------------------------------------------------------
void RequirePoint(vtkIdType id, vtkPolyData* input)
{
  if (id < 0 || id >= input->GetNumberOfPoints())
  {
    throw medial::Error(medial::ErrorCode::InvalidInput,
      "a cell names the point " + std::to_string(id) + ", but there are " +
        std::to_string(input->GetNumberOfPoints()) + ", from 0 on");
  }
}

//------------------------------------------------------------------------------
// Throws for points that the input does not have.
template <typename Visit>
void VisitCells(vtkCellArray* cells, vtkPolyData* input, const Visit& visit)
{
  vtkForEachCell(cells,
    [&](const vtkIdType* ids, vtkIdType count)
    {
      std::for_each(ids, ids + count, [&](vtkIdType id) { RequirePoint(id, input); });
      visit(ids, count);
    });
}

//------------------------------------------------------------------------------
medial::AxisEdges EdgesOf(vtkPolyData* input)
{
  medial::AxisEdges edges;
  VisitCells(input->GetPolys(), input,
    [&](const vtkIdType* ids, vtkIdType count)
    {
      for (vtkIdType i = 0; i < count; ++i)
      {
        edges.polygonEdges.push_back({ ids[i], ids[(i + 1) % count] });
      }
    });
  VisitCells(input->GetLines(), input,
    [&](const vtkIdType* ids, vtkIdType count)
    {
      for (vtkIdType i = 0; i + 1 < count; ++i)
      {
        edges.lines.push_back({ ids[i], ids[i + 1] });
      }
    });
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

//------------------------------------------------------------------------------
// The polylines as cells, with their kinds as the active cell scalars.
void AddCurves(const std::vector<medial::AxisCurve>& curves, vtkPolyData* input,
  vtkPolyData* output, vtkProgressBridge& progress)
{
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> kinds;
  kinds->SetName("AxisFeature");
  PointCopier copier(input, output);
  const std::size_t step = curves.size() / CopyingSteps + 1;
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    if (i % step == 0)
    {
      const double share = static_cast<double>(i) / static_cast<double>(curves.size());
      progress.ReportOrStop(SearchShare + (1.0 - SearchShare) * share, "points of curves");
    }
    lines->InsertNextCell(static_cast<int>(curves[i].points.size()));
    for (const vtkIdType point : curves[i].points)
    {
      lines->InsertCellPoint(copier.Copy(point));
    }
    kinds->InsertNextValue(static_cast<unsigned char>(curves[i].kind));
  }
  output->SetLines(lines);
  output->GetCellData()->SetScalars(kinds);
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialCurves::vtkMedialCurves() = default;

//------------------------------------------------------------------------------
vtkMedialCurves::~vtkMedialCurves() = default;

//------------------------------------------------------------------------------
void vtkMedialCurves::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkPolyData* input = inputs[0];
  vtkPolyData* output = outputs[0];
  vtkProgressBridge progress(this);
  progress.ReportOrStop(0.0, "edges");
  const medial::AxisEdges edges = EdgesOf(input);
  if (input->GetNumberOfPoints() == 0)
  {
    return;
  }
  progress.ReportOrStop(EdgesShare, "curves");
  std::vector<medial::AxisCurve> curves =
    medial::axisCurves(edges, static_cast<std::size_t>(input->GetNumberOfPoints()));
  const auto unwanted = [this](const medial::AxisCurve& curve)
  {
    return !(curve.kind == medial::AxisFeature::Rim && this->Rims) &&
      !(curve.kind == medial::AxisFeature::Seam && this->Seams) &&
      !(curve.kind == medial::AxisFeature::Curve && this->Curves);
  };
  curves.erase(std::remove_if(curves.begin(), curves.end(), unwanted), curves.end());
  progress.ReportOrStop(SearchShare, "points of curves");
  AddCurves(curves, input, output, progress);
}

//------------------------------------------------------------------------------
void vtkMedialCurves::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Rims: " << (this->Rims ? "On" : "Off") << "\n";
  os << indent << "Seams: " << (this->Seams ? "On" : "Off") << "\n";
  os << indent << "Curves: " << (this->Curves ? "On" : "Off") << "\n";
}
