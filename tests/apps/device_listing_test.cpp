#include "device_listing.h"

#include <gtest/gtest.h>

namespace medial::app
{
namespace
{

TEST(DeviceListing, TellsWhatIsOfferedAndWhatIsRefused)
{
  DeviceList list;
  list.devices.resize(2);
  list.devices[0].device.origin = "/dev/dri/renderD128";
  list.devices[0].refusal = "it offers no OpenGL";
  list.devices[1].device = { 1, "EGL device 1", "llvmpipe", "4.5 Mesa", true };
  list.notes = { "no driver" };
  EXPECT_EQ(deviceListing(list),
    "0  refused: it offers no OpenGL, from /dev/dri/renderD128\n"
    "1  llvmpipe (software), OpenGL 4.5 Mesa, from EGL device 1\n"
    "note: no driver\n");
  EXPECT_EQ(deviceListing({}), "EGL offers no device\n");
}

} // namespace
} // namespace medial::app
