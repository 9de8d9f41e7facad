#include "output/json_output.h"

#include "command_line.h"
#include "output/standard_output.h"

namespace medial::app
{

void checkJsonName(const char* option, const std::filesystem::path& path)
{
  if (path != kStandardOutput)
  {
    checkExtension(option, path, { ".json" });
  }
}

void printResult(const std::filesystem::path& json, bool quiet,
  const std::function<std::string()>& makeJson, const std::function<void()>& printTable)
{
  if (json == kStandardOutput)
  {
    printText(makeJson());
  }
  else if (!quiet)
  {
    printTable();
  }
}

} // namespace medial::app
