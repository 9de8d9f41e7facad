#pragma once

#include "vtkProximityConversion.h"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cstddef>
#include <vector>

namespace medial::app
{

/// Contacts and closest points of frames as a data set: that of vtkMeshProximity with the point
/// array Frame beside.
class ContactData
{
public:
  ContactData();

  void addContacts(const std::vector<Proximity>& pairs, std::size_t frame);
  /// Pairs whose closest points are not known have none.
  void addWitnesses(const std::vector<Proximity>& pairs, std::size_t frame);

  /// The data set; holds what was added so far.
  vtkPolyData* polyData() { return data_; }

private:
  /// Gives the points that were added last their frame.
  void addFrames(std::size_t frame);

  vtkProximityConversion::PointSet points_;
  vtkNew<vtkIntArray> frames_;
  vtkNew<vtkPolyData> data_;
};

} // namespace medial::app
