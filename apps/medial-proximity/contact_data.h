#pragma once

#include "medial/proximity.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cstdint>
#include <vector>

namespace medial::app
{

/// Contacts and closest points as a data set: contacts are vertices, closest points the ends of
/// lines. Point arrays: Normal, Depth, Manifold, BodyA, BodyB, CellA, CellB and Frame. At closest
/// points Normal is the direction from A to B, Depth minus the separation, and Manifold -1.
class ContactData
{
public:
  ContactData();

  /// Adds a vertex for each contact.
  void addContacts(const std::vector<Proximity>& pairs, std::size_t frame);
  /// Adds a line for each pair whose surfaces do not intersect, from A to B.
  void addWitnesses(const std::vector<Proximity>& pairs, std::size_t frame);

  /// The data set; holds what was added so far.
  vtkPolyData* polyData() { return data_; }

private:
  vtkIdType addPoint(const Proximity& pair, const ProximityContact& contact, std::size_t frame);

  vtkNew<vtkPolyData> data_;
  vtkNew<vtkDoubleArray> normals_;
  vtkNew<vtkDoubleArray> depths_;
  vtkNew<vtkIntArray> manifolds_;
  vtkNew<vtkIntArray> bodiesA_;
  vtkNew<vtkIntArray> bodiesB_;
  vtkNew<vtkIdTypeArray> cellsA_;
  vtkNew<vtkIdTypeArray> cellsB_;
  vtkNew<vtkIntArray> frames_;
};

} // namespace medial::app
