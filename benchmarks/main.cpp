#include "huge_heap.h"
#include "memory_probe.h"
#include "options.h"
#include "suites/suite.h"

#include <algorithm>
#include <exception>
#include <iostream>

namespace
{

using namespace medial::benchmark;

void runSuites(const Options& options)
{
  medial::app::useHugeHeap(); // as the programs do; all methods have it
  const Machine machine = describeMachine();
  const SuiteContext context(options,
    [&](const SuiteReport& report) { writeReport(report, machine, options.output); });
  for (const SuiteEntry& suite : suites())
  {
    if (std::find(options.suites.begin(), options.suites.end(), suite.name) != options.suites.end())
    {
      std::cerr << "== " << suite.name << '\n';
      suite.run(context);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    int exitCode = 0;
    const auto options = parseOptions(argc, argv, exitCode);
    if (options && !options->memoryOf.empty())
    {
      answerPeak(options->memoryOf, options->problem);
    }
    else if (options)
    {
      runSuites(*options);
    }
    return exitCode;
  }
  catch (const std::exception& error)
  {
    std::cerr << "medial-benchmark: " << error.what() << '\n';
    return 1;
  }
}
