// Builds without OpenVDB.
#include "failure.h"
#include "vdb_file.h"

namespace medial::app
{

bool hasOpenVdb()
{
  return false;
}

std::unique_ptr<ValueFile> makeVdbFile(const std::filesystem::path& /*file*/, const Grid& /*grid*/,
  double /*band*/)
{
  throw Failure(ExitCode::Usage, "this build is without OpenVDB");
}

} // namespace medial::app
