#pragma once

#include "medial/proximity.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <vector>

namespace medial::app
{

/// Contacts and closest points as a data set: contacts are vertices, closest points the ends of
/// lines, or a vertex where surfaces intersect. Point arrays: Kind (0 closest point, 1 contact),
/// Normal, Depth, Manifold, BodyA, BodyB, CellA, CellB and Frame. At closest points Normal is the
/// direction from A to B, 0 where they intersect; Depth is 0, and Manifold -1.
class ContactData
{
public:
  ContactData();

  /// Adds a vertex for each contact.
  void addContacts(const std::vector<Proximity>& pairs, std::size_t frame);
  /// Adds for each pair that has closest points a line from A to B, or the common point of surfaces
  /// that intersect.
  void addWitnesses(const std::vector<Proximity>& pairs, std::size_t frame);

  /// The data set; holds what was added so far.
  vtkPolyData* polyData() { return data_; }

private:
  enum Kind : unsigned char
  {
    ClosestPoint = 0,
    Contact = 1
  };

  vtkIdType addPoint(Kind kind, const Proximity& pair, const ProximityContact& place,
    std::size_t frame);

  vtkNew<vtkPolyData> data_;
  vtkNew<vtkUnsignedCharArray> kinds_;
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
