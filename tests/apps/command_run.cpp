#include "command_run.h"

#include <vtkPNGReader.h>
#include <vtkXMLPolyDataReader.h>

namespace medial::test
{

std::set<std::string> keysOf(const Json& object)
{
  std::set<std::string> keys;
  for (const auto& item : object.items())
  {
    keys.insert(item.key());
  }
  return keys;
}

vtkSmartPointer<vtkPolyData> readVtp(const std::string& path)
{
  return readWith<vtkXMLPolyDataReader>(path);
}

vtkSmartPointer<vtkImageData> readPng(const std::string& path)
{
  return readWith<vtkPNGReader>(path);
}

Outcome CommandRun::run(std::vector<std::string> arguments) const
{
  arguments.insert(arguments.begin(), input);
  Outcome outcome = runMedialAxis(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  return outcome;
}

} // namespace medial::test
