#pragma once

#include "medial/device.h"

#include <filesystem>
#include <string>
#include <vector>

namespace medial::gl
{

/// Returns sentences about hardware that the system has but EGL does not offer, such as a GPU in a
/// container without the driver's files, where only a software renderer is left.
/// @param root of the file system.
std::vector<std::string> missingDrivers(const std::vector<ListedDevice>& devices,
  const std::filesystem::path& root = "/");

} // namespace medial::gl
