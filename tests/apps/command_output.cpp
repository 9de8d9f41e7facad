#include "command_output.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace medial::test
{

Outcome CommandOutput::run(std::vector<std::string> arguments) const
{
  if (std::find(arguments.begin(), arguments.end(), "--spacing") == arguments.end())
  {
    arguments.insert(arguments.end(), { "--resolution", std::to_string(kResolution) });
  }
  return CommandRun::run(arguments);
}

vtkSmartPointer<vtkPolyData> CommandOutput::axis(std::vector<std::string> arguments) const
{
  arguments.insert(arguments.end(), { "-o", folder.file("axis.vtp") });
  this->run(arguments);
  return readVtp(folder.file("axis.vtp"));
}

Json CommandOutput::report(std::vector<std::string> arguments) const
{
  arguments.insert(arguments.end(), { "--report", folder.file("report.json") });
  this->run(arguments);
  return Json::parse(readFile(folder.file("report.json")));
}

double radiusAt(vtkPolyData* axis, vtkIdType point)
{
  return axis->GetPointData()->GetArray("Radius")->GetTuple1(point);
}

double exactRadius(const double* point)
{
  return std::min({ kHalfSides[0] - std::abs(point[0]), kHalfSides[1] - std::abs(point[1]),
    kHalfSides[2] - std::abs(point[2]) });
}

} // namespace medial::test
