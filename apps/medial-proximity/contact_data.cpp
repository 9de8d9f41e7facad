#include "contact_data.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

namespace medial::app
{

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
  add(normals_, "Normal");
  add(depths_, "Depth");
  add(manifolds_, "Manifold");
  add(bodiesA_, "BodyA");
  add(bodiesB_, "BodyB");
  add(cellsA_, "CellA");
  add(cellsB_, "CellB");
  add(frames_, "Frame");
}

vtkIdType ContactData::addPoint(const Proximity& pair, const ProximityContact& contact,
  std::size_t frame)
{
  normals_->InsertNextTuple(contact.normal.data());
  depths_->InsertNextValue(contact.depth);
  manifolds_->InsertNextValue(contact.manifold);
  bodiesA_->InsertNextValue(pair.meshA);
  bodiesB_->InsertNextValue(pair.meshB);
  cellsA_->InsertNextValue(contact.cellA);
  cellsB_->InsertNextValue(contact.cellB);
  frames_->InsertNextValue(static_cast<int>(frame));
  return data_->GetPoints()->InsertNextPoint(contact.point.data());
}

void ContactData::addContacts(const std::vector<Proximity>& pairs, std::size_t frame)
{
  for (const Proximity& pair : pairs)
  {
    for (const ProximityContact& contact : pair.contacts)
    {
      const vtkIdType point = this->addPoint(pair, contact, frame);
      data_->GetVerts()->InsertNextCell(1, &point);
    }
  }
}

void ContactData::addWitnesses(const std::vector<Proximity>& pairs, std::size_t frame)
{
  for (const Proximity& pair : pairs)
  {
    if (pair.intersect)
    {
      continue;
    }
    ProximityContact end;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      end.normal[axis] = (pair.witnessB[axis] - pair.witnessA[axis]) / pair.separation;
    }
    end.depth = -pair.separation;
    end.manifold = -1;
    end.cellA = pair.cellA;
    end.cellB = pair.cellB;
    end.point = pair.witnessA;
    const vtkIdType first = this->addPoint(pair, end, frame);
    end.point = pair.witnessB;
    const vtkIdType ends[2] = { first, this->addPoint(pair, end, frame) };
    data_->GetLines()->InsertNextCell(2, ends);
  }
}

} // namespace medial::app
