#include "scan_input.h"

#include "files/scans/scan_reader.h"
#include "input/surface_reader.h"
#include "library_calls.h"

namespace fs = std::filesystem;

namespace medial::app
{

std::vector<fs::path> filesOfScan(const fs::path& path)
{
  const fs::path values = files::valuesFileOf(path);
  return values.empty() ? std::vector{ path } : std::vector{ path, values };
}

Surface readSurface(const fs::path& path, const ScanSurface& wanted)
{
  if (!isScanFile(path))
  {
    return readSurface(path);
  }
  Surface surface;
  withFailures(
    [&] { surface = Surface(files::extractSurface(files::readScan(path), wanted, path)); });
  return surface;
}

Sequence readSequence(const std::vector<fs::path>& inputs, const ScanSurface& wanted)
{
  return readSequence(inputs, [&](const fs::path& path) { return readSurface(path, wanted); });
}

} // namespace medial::app
