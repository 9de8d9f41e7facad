#include "proximity_run.h"

namespace medial::test
{

ProximityRun::ProximityRun()
{
  writeFile(large, offText(box({ 1.0, 1.0, 1.0 })));
  writeFile(small, offText(box({ 0.5, 0.5, 0.5 })));
}

std::vector<std::string> ProximityRun::cubes(double x, const std::vector<std::string>& more) const
{
  std::vector<std::string> arguments{ large, small, "--transform",
    "1=1,0,0," + std::to_string(x) + ",0,1,0,0,0,0,1,0" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

Outcome ProximityRun::run(double x, const std::vector<std::string>& arguments) const
{
  Outcome outcome = runMedialProximity(cubes(x, arguments));
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome;
}

Json ProximityRun::json(std::vector<std::string> arguments)
{
  arguments.insert(arguments.end(), { "--json", "-" });
  const Outcome outcome = runMedialProximity(arguments);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return Json::parse(outcome.out);
}

Json ProximityRun::pair(double x, const std::vector<std::string>& arguments) const
{
  return json(cubes(x, arguments))["frames"][0]["pairs"][0];
}

std::string ProximityRun::failure(int exitCode, std::vector<std::string> arguments,
  const RunOptions& options)
{
  const TemporaryFolder outputs;
  arguments.insert(arguments.end(),
    { "--json", outputs.file("result.json"), "--contacts", outputs.file("contacts.pvd"), "--image",
      outputs.file("picture.png"), "--animation", outputs.file("pictures") });
  const Outcome outcome = runMedialProximity(arguments, options);
  EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err.rfind("medial-proximity: ", 0), 0U) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  EXPECT_EQ(outputs.list(), std::vector<std::string>());
  return outcome.err;
}

} // namespace medial::test
