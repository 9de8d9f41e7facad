#include "device_listing.h"

namespace medial::app
{

std::string deviceListing(const DeviceList& list)
{
  std::string text;
  for (const ListedDevice& listed : list.devices)
  {
    const Device& device = listed.device;
    text += std::to_string(device.number) + "  ";
    text += listed.refusal.empty()
      ? device.renderer + (device.software ? " (software)" : "") + ", OpenGL " + device.version
      : "refused: " + listed.refusal;
    text += ", from " + device.origin + "\n";
  }
  if (list.devices.empty())
  {
    text += "EGL offers no device\n";
  }
  for (const std::string& note : list.notes)
  {
    text += "note: " + note + "\n";
  }
  return text;
}

} // namespace medial::app
