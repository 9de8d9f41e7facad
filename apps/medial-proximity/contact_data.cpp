#include "contact_data.h"

#include <vtkPointData.h>

namespace medial::app
{

ContactData::ContactData()
{
  points_.ShareWith(data_);
  frames_->SetName("Frame");
  data_->GetPointData()->AddArray(frames_);
}

void ContactData::addContacts(const std::vector<Proximity>& pairs, std::size_t frame)
{
  for (const Proximity& pair : pairs)
  {
    points_.AddContacts(pair);
  }
  this->addFrames(frame);
}

void ContactData::addWitnesses(const std::vector<Proximity>& pairs, std::size_t frame)
{
  for (const Proximity& pair : pairs)
  {
    points_.AddWitnesses(pair);
  }
  this->addFrames(frame);
}

void ContactData::addFrames(std::size_t frame)
{
  while (frames_->GetNumberOfValues() < data_->GetNumberOfPoints())
  {
    frames_->InsertNextValue(static_cast<int>(frame));
  }
}

} // namespace medial::app
