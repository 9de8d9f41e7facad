// Any bytes as a file of an axis: it is read, or refused.
#include "fuzz_file.h"

#include "input/model_reader.h"
#include "library_calls.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  using namespace medial;
  fuzz::readBytes(MEDIAL_FUZZ_FILE, data, size,
    [](const std::string& path)
    {
      const MedialModel model = app::readModel(path);
      app::withFailures(path, [&] { checkMedialModel(model); });
    });
  return 0;
}
