#include "volumes/vdb_file.h"

#include "failure.h"
#include "vdb_module.h"

#include <dlfcn.h>

#include <string>

namespace medial::app
{
namespace
{

MakeVdbFile* makeFile = nullptr;

} // namespace

// The module stays loaded: OpenVDB's threads do not end before the process.
void loadVdb(const std::filesystem::path& file)
{
  void* const module = dlopen("libmedial-vdb.so", RTLD_NOW | RTLD_LOCAL);
  makeFile =
    module != nullptr ? reinterpret_cast<MakeVdbFile*>(dlsym(module, "makeVdbFile")) : nullptr;
  if (makeFile == nullptr)
  {
    throw Failure(ExitCode::Usage,
      "--field " + file.string() + ": this build is without OpenVDB, or that is not installed (" +
        dlerror() + ")");
  }
}

std::unique_ptr<ValueFile> makeVdbFile(const std::filesystem::path& file, const Grid& grid,
  double band)
{
  return std::unique_ptr<ValueFile>(makeFile(file.c_str(), grid, band));
}

} // namespace medial::app
