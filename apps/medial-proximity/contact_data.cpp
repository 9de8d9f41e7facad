#include "contact_data.h"

#include "proximity_results.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace medial::app
{
namespace
{

// The closest point of A in the form of a contact.
ProximityContact witnessOf(const Proximity& pair)
{
  ProximityContact witness;
  witness.point = pair.witnessA;
  witness.manifold = -1;
  witness.cellA = pair.cellA;
  witness.cellB = pair.cellB;
  for (std::size_t axis = 0; axis < 3 && pair.separation > 0.0; ++axis)
  {
    witness.normal[axis] = (pair.witnessB[axis] - pair.witnessA[axis]) / pair.separation;
  }
  return witness;
}

} // namespace

ContactData::ContactData()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  data_->SetPoints(points);
  data_->SetVerts(vtkNew<vtkCellArray>());
  data_->SetLines(vtkNew<vtkCellArray>());
  normals_->SetNumberOfComponents(3);
  const auto add = [this](vtkDataArray* array, const char* name)
  {
    array->SetName(name);
    data_->GetPointData()->AddArray(array);
  };
  add(kinds_, "Kind");
  add(normals_, "Normal");
  add(depths_, "Depth");
  add(manifolds_, "Manifold");
  add(bodiesA_, "BodyA");
  add(bodiesB_, "BodyB");
  add(cellsA_, "CellA");
  add(cellsB_, "CellB");
  add(frames_, "Frame");
}

vtkIdType ContactData::addPoint(Kind kind, const Proximity& pair, const ProximityContact& place,
  std::size_t frame)
{
  kinds_->InsertNextValue(kind);
  normals_->InsertNextTuple(place.normal.data());
  depths_->InsertNextValue(place.depth);
  manifolds_->InsertNextValue(place.manifold);
  bodiesA_->InsertNextValue(pair.meshA);
  bodiesB_->InsertNextValue(pair.meshB);
  cellsA_->InsertNextValue(place.cellA);
  cellsB_->InsertNextValue(place.cellB);
  frames_->InsertNextValue(static_cast<int>(frame));
  return data_->GetPoints()->InsertNextPoint(place.point.data());
}

void ContactData::addContacts(const std::vector<Proximity>& pairs, std::size_t frame)
{
  for (const Proximity& pair : pairs)
  {
    for (const ProximityContact& contact : pair.contacts)
    {
      data_->GetVerts()->InsertNextCell({ this->addPoint(Contact, pair, contact, frame) });
    }
  }
}

void ContactData::addWitnesses(const std::vector<Proximity>& pairs, std::size_t frame)
{
  for (const Proximity& pair : pairs)
  {
    if (!hasWitnesses(pair))
    {
      continue;
    }
    ProximityContact witness = witnessOf(pair);
    const vtkIdType a = this->addPoint(ClosestPoint, pair, witness, frame);
    if (pair.intersect)
    {
      data_->GetVerts()->InsertNextCell({ a });
      continue;
    }
    witness.point = pair.witnessB;
    data_->GetLines()->InsertNextCell({ a, this->addPoint(ClosestPoint, pair, witness, frame) });
  }
}

} // namespace medial::app
