#include "program.h"

#include "failure.h"
#include "output/output_names.h"
#include "program_main.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace medial::test
{
namespace
{

using app::ExitCode;
using app::Failure;

/// The work must end a program with `exitCode` and nothing but the line `message`, a regular
/// expression.
void expectEnd(int exitCode, const std::string& message, const std::function<void()>& work)
{
  EXPECT_EXIT(std::exit(app::runProgram("medial-axis", work)), testing::ExitedWithCode(exitCode),
    "^" + (message.empty() ? "" : "medial-axis: " + message + "\n") + "$");
}

TEST(ProgramMainDeathTest, FailuresHaveTheirOwnExitCode)
{
  expectEnd(0, "", [] {});
  expectEnd(kBadInput, "a.obj: is bad", [] { throw Failure(ExitCode::BadInput, "a.obj: is bad"); });
  expectEnd(kInterrupted, "stopped", [] { throw Failure(ExitCode::Interrupted, "stopped"); });
}

TEST(ProgramMainDeathTest, ALackOfMemoryOrThreadsIsNoFaultOfTheProgram)
{
  expectEnd(kNoSpace, "not enough memory", [] { throw std::bad_alloc(); });
  expectEnd(kNoSpace, "not enough memory", [] { throw std::bad_array_new_length(); });
  expectEnd(kNoSpace, "no memory for another thread: .*",
    []
    { throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)); });
  expectEnd(kNoSpace, "no memory for another thread: .*", // as TBB says it
    [] {
      throw std::runtime_error(std::string("pthread_create has failed: ") + std::strerror(EAGAIN));
    });
}

TEST(ProgramMainDeathTest, ALackOfMemoryEndsAProgramThereAndThen)
{
  expectEnd(kNoSpace, "not enough memory",
    []
    {
      try
      {
        std::get_new_handler()(); // as operator new does
        throw std::bad_alloc();
      }
      catch (const std::bad_alloc&) // as streams do
      {
        throw Failure(ExitCode::BadInput, "a.vtp: is bad");
      }
    });
}

TEST(ProgramMainDeathTest, AnyOtherExceptionIsAFaultOfTheProgram)
{
  expectEnd(kFault, "a fault of the program: vector::at",
    [] { throw std::out_of_range("vector::at"); });
  expectEnd(kFault, "a fault of the program: two lines",
    [] { throw std::logic_error("two\nlines"); });
  expectEnd(kFault, "a fault of the program: an exception of an unknown type", [] { throw 1; });
}

// The lines of a summary, and a failure that comes with it.
TEST(ProgramMainDeathTest, LosesNothingThatWasPrinted)
{
  const auto print = [](std::size_t count)
  {
    ASSERT_NE(std::freopen("/dev/full", "w", stdout), nullptr);
    std::printf("%s\n", std::string(count, '-').c_str());
  };
  expectEnd(kNoSpace, "standard output: cannot be written: No space left on device",
    [&] { print(9); });
  expectEnd(kNoSpace, "standard output: cannot be written.*", [&] { print(100000); });
  EXPECT_EXIT(std::exit(app::runProgram("medial-axis",
                [&]
                {
                  print(9);
                  throw Failure(ExitCode::BeyondLimits, "beyond its limits");
                })),
    testing::ExitedWithCode(kNoSpace), "beyond its limits\n.*standard output: cannot be written");
}

/// Lets no exception out, as destructors do.
void withoutWayOut(const std::function<void()>& work) noexcept
{
  work();
}

TEST(ProgramMainDeathTest, AnExceptionThatNobodyCanCatchIsAFaultOfTheProgram)
{
  expectEnd(kFault, "a fault of the program: beyond all help",
    [] { withoutWayOut([] { throw std::logic_error("beyond all help"); }); });
  expectEnd(kNoSpace, "not enough memory", [] { withoutWayOut([] { throw std::bad_alloc(); }); });
}

TEST(CommandLineDeathTest, FilesInAFolderThatIsGoneAreStillTwo)
{
  const auto inFolderThatIsGone = [](const char* other)
  {
    std::string folder = (std::filesystem::temp_directory_path() / "medial-XXXXXX").string();
    std::filesystem::current_path(mkdtemp(folder.data()));
    std::filesystem::remove(folder);
    app::checkNames({ { "--output", "a.vtp" }, { "--curves", other } }, {});
  };
  expectEnd(0, "", [&] { inFolderThatIsGone("b.vtp"); });
  expectEnd(kUsage, "--output and --curves name the same file, a.vtp",
    [&] { inFolderThatIsGone("./a.vtp"); });
}

} // namespace
} // namespace medial::test
