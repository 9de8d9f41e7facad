#include "gl/egl_context.h"
#include "gl/missing_drivers.h"
#include "medial/device.h"

#include <future>

namespace medial
{

DeviceList listDevices()
{
  // A thread of its own, since the caller's may have a context that is current.
  const auto list = []
  {
    DeviceList found;
    found.devices = gl::openableDevices();
    found.notes = gl::missingDrivers(found.devices);
    return found;
  };
  return std::async(std::launch::async, list).get();
}

} // namespace medial
