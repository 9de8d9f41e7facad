// Any bytes as a mesh file: it is read, or refused.
#include "fuzz_file.h"

#include "input/surface_reader.h"
#include "library_calls.h"

#include "medial/mesh_connectivity.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace medial;
  fuzz::readBytes(MEDIAL_FUZZ_FILE, data, size,
    [](const std::string& path)
    {
      app::Surface surface = app::readSurface(path);
      app::withFailures(path, [&] { analyseConnectivity(surface.toTriangleMesh()); });
      surface.polyData();
    });
  return 0;
}
