// Any bytes as an image: it is read and has a surface, or is refused.
#include "fuzz_file.h"

#include "scan_reader.h"
#include "scan_surface.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace medial;
  fuzz::readBytes(MEDIAL_FUZZ_FILE, data, size,
    [](const std::string& path)
    {
      const app::Scan scan = app::readScan(path);
      constexpr vtkIdType kMost = 100'000; // so that surfaces of compressed images take no seconds
      if (scan.image->GetNumberOfPoints() <= kMost)
      {
        app::ScanSurface wanted;
        wanted.isovalue = 0.5;
        app::extractSurface(scan, wanted, path);
      }
    });
  return 0;
}
