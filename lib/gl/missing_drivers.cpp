#include "gl/missing_drivers.h"

#include <algorithm>
#include <system_error>

#include <unistd.h>

namespace medial::gl
{
namespace
{

namespace fs = std::filesystem;

bool isThere(const fs::path& path)
{
  std::error_code ignored;
  return fs::exists(path, ignored);
}

bool offers(const std::vector<ListedDevice>& devices, const char* name)
{
  return std::any_of(devices.begin(), devices.end(),
    [name](const ListedDevice& listed)
    { return !listed.device.software && listed.device.renderer.find(name) != std::string::npos; });
}

/// Returns the files of GPUs under /dev/dri, sorted.
std::vector<fs::path> renderNodes(const fs::path& root)
{
  std::vector<fs::path> nodes;
  std::error_code ignored;
  for (fs::directory_iterator entry(root / "dev/dri", ignored), end; entry != end;
       entry.increment(ignored))
  {
    if (entry->path().filename().string().rfind("renderD", 0) == 0)
    {
      nodes.push_back(entry->path());
    }
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

} // namespace

std::vector<std::string> missingDrivers(const std::vector<ListedDevice>& devices,
  const fs::path& root)
{
  std::vector<std::string> notes;
  const bool nvidia =
    isThere(root / "proc/driver/nvidia/version") || isThere(root / "dev/nvidiactl");
  if (nvidia && !offers(devices, "NVIDIA"))
  {
    notes.emplace_back(
      "the system has NVIDIA's driver, but EGL offers no NVIDIA device: is 10_nvidia.json in "
      "/usr/share/glvnd/egl_vendor.d, and libEGL_nvidia.so.0 installed? (containers: "
      "NVIDIA_DRIVER_CAPABILITIES=all)");
  }
  for (const fs::path& node : renderNodes(root))
  {
    const bool open = access(node.c_str(), R_OK | W_OK) == 0;
    const bool offered = offers(devices, "");
    if (!open || !offered)
    {
      notes.push_back(open ? node.string() +
            " exists, but EGL offers no hardware: is its driver installed "
            "(Debian: libgl1-mesa-dri)?"
                           : node.string() + " cannot be opened: is the user in the group render?");
    }
  }
  return notes;
}

} // namespace medial::gl
