#include "vtkProximityConversion.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMedialFigures.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

enum Kinds : unsigned char
{
  WITNESS = 0,
  CONTACT = 1
};

//------------------------------------------------------------------------------
/// The points of the output and their arrays, as they grow.
class MarkedPoints
{
public:
  explicit MarkedPoints(const medial::Proximity& proximity)
    : Proximity(proximity)
  {
    this->Points->SetDataTypeToDouble();
    this->Normal->SetNumberOfComponents(3);
  }

  vtkIdType Add(Kinds kind, const medial::ProximityContact& place)
  {
    this->Kind->InsertNextValue(kind);
    this->Normal->InsertNextTypedTuple(place.normal.data());
    this->Depth->InsertNextValue(place.depth);
    this->Manifold->InsertNextValue(place.manifold);
    this->BodyA->InsertNextValue(this->Proximity.meshA);
    this->BodyB->InsertNextValue(this->Proximity.meshB);
    this->CellA->InsertNextValue(place.cellA);
    this->CellB->InsertNextValue(place.cellB);
    return this->Points->InsertNextPoint(place.point.data());
  }

  void MoveTo(vtkPolyData* output)
  {
    output->SetPoints(this->Points);
    const auto attach = [output](const char* name, vtkDataArray* array)
    {
      array->SetName(name);
      output->GetPointData()->AddArray(array);
    };
    attach("Kind", this->Kind);
    attach("Normal", this->Normal);
    attach("Depth", this->Depth);
    attach("Manifold", this->Manifold);
    attach("BodyA", this->BodyA);
    attach("BodyB", this->BodyB);
    attach("CellA", this->CellA);
    attach("CellB", this->CellB);
    output->GetPointData()->SetActiveScalars("Kind");
    output->GetPointData()->SetActiveVectors("Normal");
  }

private:
  const medial::Proximity& Proximity;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkUnsignedCharArray> Kind;
  vtkNew<vtkDoubleArray> Normal;
  vtkNew<vtkDoubleArray> Depth;
  vtkNew<vtkIntArray> Manifold;
  vtkNew<vtkIntArray> BodyA;
  vtkNew<vtkIntArray> BodyB;
  vtkNew<vtkIdTypeArray> CellA;
  vtkNew<vtkIdTypeArray> CellB;
};

//------------------------------------------------------------------------------
/// A witness in the form of a contact.
medial::ProximityContact ToWitness(const medial::Proximity& proximity, const medial::Point3& point)
{
  medial::ProximityContact witness;
  witness.point = point;
  witness.manifold = -1;
  witness.cellA = proximity.cellA;
  witness.cellB = proximity.cellB;
  for (int axis = 0; axis < 3 && proximity.separation > 0.0; ++axis)
  {
    witness.normal[axis] =
      (proximity.witnessB[axis] - proximity.witnessA[axis]) / proximity.separation;
  }
  return witness;
}

} // namespace

//------------------------------------------------------------------------------
void vtkProximityConversion::ToPolyData(const medial::Proximity& proximity, vtkPolyData* output)
{
  MarkedPoints points(proximity);
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  if (proximity.intersect)
  {
    verts->InsertNextCell({ points.Add(WITNESS, ToWitness(proximity, proximity.witnessA)) });
  }
  else if (std::isfinite(proximity.separation))
  {
    const vtkIdType a = points.Add(WITNESS, ToWitness(proximity, proximity.witnessA));
    const vtkIdType b = points.Add(WITNESS, ToWitness(proximity, proximity.witnessB));
    lines->InsertNextCell({ a, b });
  }
  for (const medial::ProximityContact& contact : proximity.contacts)
  {
    verts->InsertNextCell({ points.Add(CONTACT, contact) });
  }
  points.MoveTo(output);
  output->SetVerts(verts);
  output->SetLines(lines);
}

//------------------------------------------------------------------------------
void vtkProximityConversion::AddFigures(const medial::Proximity& proximity,
  const medial::ProximityOptions& options, vtkPolyData* output)
{
  vtkMedialFigures figures(output);
  figures.AddNumber("Separation", proximity.separation);
  figures.AddFlag("Collide", proximity.collide);
  figures.AddFlag("Intersect", proximity.intersect);
  figures.AddFlag("InsideUndefined", proximity.insideUndefined);
  if (options.depths)
  {
    figures.AddNumber("PenetrationDepth", proximity.depth);
    figures.AddNumber("PenetrationDepthAtMost", proximity.depthAtMost);
    const bool inside = proximity.depth > 0.0;
    figures.AddPoint("DeepestPoint",
      inside ? proximity.deepestPoint : medial::Point3{ NaN, NaN, NaN });
  }
  if (options.translationalDepth)
  {
    const medial::DepthBounds& bounds = proximity.translationalDepth;
    figures.AddParts("TranslationalDepth",
      { { "Lower", bounds.lower }, { "Upper", bounds.upper } });
    figures.AddPoint("SeparatingTranslation", proximity.separatingTranslation);
  }
  figures.AddNumber("Seconds", proximity.seconds);
}

//------------------------------------------------------------------------------
void vtkProximityConversion::AddDepths(const medial::Proximity& proximity,
  const std::vector<medial::PointDepth>& depths, const medial::TriangleMesh& mesh,
  vtkPolyData* surface)
{
  std::vector<double> ofPoints(mesh.points.size(), proximity.insideUndefined ? NaN : 0.0);
  for (const medial::PointDepth& depth : depths)
  {
    ofPoints[depth.point] = depth.depth;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName("PenetrationDepth");
  array->SetNumberOfValues(static_cast<vtkIdType>(mesh.pointOfInput.size()));
  std::transform(mesh.pointOfInput.begin(), mesh.pointOfInput.end(), array->GetPointer(0),
    [&](int point) { return point >= 0 ? ofPoints[point] : NaN; });
  surface->GetPointData()->AddArray(array);
  surface->GetPointData()->SetActiveScalars("PenetrationDepth");
}
