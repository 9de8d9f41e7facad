#include "vtkMedialReconstruction.h"

#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMedialModelConversion.h"
#include "vtkMedialProgress.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "medial/memory.h"
#include "medial/reconstruction.h"

#include <algorithm>
#include <functional>
#include <vector>

vtkStandardNewMacro(vtkMedialReconstruction);

namespace
{

/// The field's share of the work; the rest is contouring.
constexpr double FieldShare = 0.9;

/// The field, VTK's copy of it, and what the contour filter notes about each edge.
constexpr int BytesPerGridPoint = 2 * sizeof(float) + 1;

//------------------------------------------------------------------------------
// The contour filter makes points in single precision, which suffices only near the origin.
void MoveTo(const medial::Point3& origin, vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(surface->GetNumberOfPoints());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double x[3];
    surface->GetPoint(i, x);
    points->SetPoint(i, origin[0] + x[0], origin[1] + x[1], origin[2] + x[2]);
  }
  surface->SetPoints(points);
}

//------------------------------------------------------------------------------
void Contour(const medial::Grid& grid, const std::vector<float>& field, vtkPolyData* output)
{
  vtkNew<vtkFloatArray> values;
  values->SetName("Depth");
  values->SetNumberOfValues(static_cast<vtkIdType>(field.size()));
  // The contour filter takes high values for the inside. Negated, triangles and normals face
  // outwards.
  std::transform(field.begin(), field.end(), values->GetPointer(0), std::negate<float>());
  vtkNew<vtkImageData> image;
  image->SetSpacing(grid.spacing.data());
  image->SetDimensions(grid.dimensions.data());
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  contour->Update();
  output->ShallowCopy(contour->GetOutput());
  MoveTo(grid.origin, output);
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialReconstruction::vtkMedialReconstruction() = default;

//------------------------------------------------------------------------------
vtkMedialReconstruction::~vtkMedialReconstruction() = default;

//------------------------------------------------------------------------------
void vtkMedialReconstruction::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkProgressBridge bridge(this);
  vtkProgressPart progress(bridge, 0.0, FieldShare);
  const medial::MedialModel model = vtkMedialModelConversion::ToMedialModel(inputs[0]);
  const medial::Grid grid = medial::makeGrid(medial::modelBounds(model), this->Resolution);
  medial::requireMemory(grid.pointCount(), BytesPerGridPoint);
  const std::vector<float> field =
    medial::computeReconstruction(model, grid, { this->Interpolate != 0, { 0, &progress } });
  bridge.ReportOrStop(FieldShare, "contour");
  Contour(grid, field, outputs[0]);
}

//------------------------------------------------------------------------------
void vtkMedialReconstruction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Interpolate: " << (this->Interpolate ? "On" : "Off") << "\n";
}
