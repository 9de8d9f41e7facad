#include "vtkProximityConversion.h"

#include "vtkMedialFigures.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

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
vtkProximityConversion::PointSet::PointSet()
{
  this->Points->SetDataTypeToDouble();
  this->Normal->SetNumberOfComponents(3);
}

//------------------------------------------------------------------------------
vtkIdType vtkProximityConversion::PointSet::Add(Kinds kind, const medial::Proximity& pair,
  const medial::ProximityContact& place)
{
  this->Kind->InsertNextValue(kind);
  this->Normal->InsertNextTypedTuple(place.normal.data());
  this->Depth->InsertNextValue(place.depth);
  this->Manifold->InsertNextValue(place.manifold);
  this->BodyA->InsertNextValue(pair.meshA);
  this->BodyB->InsertNextValue(pair.meshB);
  this->CellA->InsertNextValue(place.cellA);
  this->CellB->InsertNextValue(place.cellB);
  return this->Points->InsertNextPoint(place.point.data());
}

//------------------------------------------------------------------------------
void vtkProximityConversion::PointSet::AddWitnesses(const medial::Proximity& pair)
{
  if (pair.intersect)
  {
    this->Verts->InsertNextCell({ this->Add(WITNESS, pair, ToWitness(pair, pair.witnessA)) });
  }
  else if (std::isfinite(pair.separation))
  {
    const vtkIdType a = this->Add(WITNESS, pair, ToWitness(pair, pair.witnessA));
    const vtkIdType b = this->Add(WITNESS, pair, ToWitness(pair, pair.witnessB));
    this->Lines->InsertNextCell({ a, b });
  }
}

//------------------------------------------------------------------------------
void vtkProximityConversion::PointSet::AddContacts(const medial::Proximity& pair)
{
  for (const medial::ProximityContact& contact : pair.contacts)
  {
    this->Verts->InsertNextCell({ this->Add(CONTACT, pair, contact) });
  }
}

//------------------------------------------------------------------------------
void vtkProximityConversion::PointSet::ShareWith(vtkPolyData* output)
{
  output->SetPoints(this->Points);
  output->SetVerts(this->Verts);
  output->SetLines(this->Lines);
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
    figures.AddPoint("SeparatingTranslation",
      std::isfinite(bounds.upper) ? proximity.separatingTranslation
                                  : medial::Point3{ NaN, NaN, NaN });
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
