#include "gl/missing_drivers.h"
#include "support/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace medial::gl
{
namespace
{

using test::TemporaryFolder;

/// A system with some files below its root.
class MissingDrivers : public testing::Test
{
protected:
  void add(const std::filesystem::path& file)
  {
    std::filesystem::create_directories((root_.path() / file).parent_path());
    std::ofstream{ root_.path() / file };
  }

  std::vector<std::string> notes(const std::string& renderer, bool software)
  {
    ListedDevice listed;
    listed.device.renderer = renderer;
    listed.device.software = software;
    return missingDrivers({ listed }, root_.path());
  }

  TemporaryFolder root_;
};

TEST_F(MissingDrivers, SaysNothingWithoutHardware)
{
  EXPECT_TRUE(this->notes("llvmpipe", true).empty());
}

TEST_F(MissingDrivers, NamesTheVendorFileWhereNvidiasDriverIsNotOffered)
{
  this->add("proc/driver/nvidia/version");
  const std::vector<std::string> notes = this->notes("llvmpipe", true);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("10_nvidia.json"), std::string::npos) << notes[0];
  EXPECT_TRUE(this->notes("NVIDIA H100 80GB HBM3/PCIe/SSE2", false).empty());
}

TEST_F(MissingDrivers, NamesRenderNodesThatNoHardwareIsOfferedFor)
{
  this->add("dev/dri/renderD128");
  this->add("dev/dri/card0");
  const std::vector<std::string> notes = this->notes("llvmpipe", true);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("renderD128"), std::string::npos) << notes[0];
  EXPECT_TRUE(this->notes("AMD Radeon", false).empty());
}

TEST(ListDevices, NumbersWhatEglOffers)
{
  const DeviceList list = listDevices();
  ASSERT_FALSE(list.devices.empty());
  for (std::size_t i = 0; i < list.devices.size(); ++i)
  {
    const ListedDevice& listed = list.devices[i];
    EXPECT_EQ(listed.device.number, static_cast<int>(i));
    EXPECT_FALSE(listed.device.origin.empty());
    EXPECT_EQ(listed.refusal.empty(), !listed.device.renderer.empty());
  }
}

} // namespace
} // namespace medial::gl
