// Any bytes as an image: it is read and has a surface, or is refused.
#include "fuzz_file.h"

#include "files/scans/scan_reader.h"
#include "files/scans/scan_surface.h"
#include "library_calls.h"

namespace
{

void extractSurface(const std::string& path)
{
  using namespace medial;
  const files::Scan scan = files::readScan(path);
  constexpr vtkIdType kMost = 100'000; // so that surfaces of compressed images take no seconds
  if (scan.image->GetNumberOfPoints() <= kMost)
  {
    files::ScanSurface wanted;
    wanted.isovalue = 0.5;
    files::extractSurface(scan, wanted, path);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace medial;
  fuzz::readBytes(MEDIAL_FUZZ_FILE, data, size,
    [](const std::string& path) { app::withFailures([&] { extractSurface(path); }); });
  return 0;
}
