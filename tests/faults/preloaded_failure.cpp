// For LD_PRELOAD: makes allocations of a program fail, while main() runs.
//
// MEDIAL_FAIL_ALLOCATION=N          the N-th one fails
// MEDIAL_FAIL_ALLOCATIONS_FROM=N    the N-th one and all that follow fail
// MEDIAL_COUNT_ALLOCATIONS=FILE     their number goes to the file when main() returns
#include "failing_allocations.h"

#include <cstdio>
#include <cstdlib>

#include <dlfcn.h>

namespace
{

using Main = int (*)(int, char**, char**);
using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);

Main programMain = nullptr;

std::int64_t numberIn(const char* variable)
{
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoll(text) : 0;
}

void writeCount(std::int64_t count)
{
  const char* name = std::getenv("MEDIAL_COUNT_ALLOCATIONS");
  if (name == nullptr)
  {
    return;
  }
  if (std::FILE* file = std::fopen(name, "w"))
  {
    std::fprintf(file, "%lld\n", static_cast<long long>(count));
    std::fclose(file);
  }
}

int mainWithFailures(int argc, char** argv, char** environment)
{
  using namespace medial::test;
  const std::int64_t from = numberIn("MEDIAL_FAIL_ALLOCATIONS_FROM");
  if (from > 0)
  {
    failAllocation(from, Failing::FromOn);
  }
  else
  {
    failAllocation(numberIn("MEDIAL_FAIL_ALLOCATION"), Failing::Once);
  }
  const int exitCode = programMain(argc, argv, environment);
  writeCount(stopFailing());
  return exitCode;
}

} // namespace

/// Takes the place of glibc's function, which calls main().
extern "C" int startProgram(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
  void (*loader)(), void* stack) __asm__("__libc_start_main");

int startProgram(Main main, int argc, char** argv, void (*init)(), void (*fini)(), void (*loader)(),
  void* stack)
{
  programMain = main;
  const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return start(mainWithFailures, argc, argv, init, fini, loader, stack);
}
