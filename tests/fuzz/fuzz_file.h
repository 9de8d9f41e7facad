#pragma once

#include "failure.h"

#include "support/files.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace medial::fuzz
{

/// Ends the program with a finding.
[[noreturn]] inline void report(const std::string& finding)
{
  std::fprintf(stderr, "FINDING: %s\n", finding.c_str());
  std::abort();
}

/// Writes bytes to a file and reads it back with `read`. A file may be refused, in one printable
/// line that names it and with the exit code of bad input; anything else is a finding.
template <typename Read>
void readBytes(const char* name, const std::uint8_t* data, std::size_t size, const Read& read)
{
  static const test::TemporaryFolder folder;
  const std::string path = folder.file(name);
  test::writeFile(path, std::string(reinterpret_cast<const char*>(data), size));
  try
  {
    read(path);
  }
  catch (const app::Failure& failure)
  {
    const std::string message = failure.what();
    if (failure.exitCode() != app::ExitCode::BadInput || message.rfind(path + ": ", 0) != 0)
    {
      report(
        "refused with " + std::to_string(static_cast<int>(failure.exitCode())) + ": " + message);
    }
    for (const char character : message)
    {
      if (static_cast<unsigned char>(character) < ' ' || character == 127)
      {
        report("a message with control characters: " + message);
      }
    }
    if (message.size() > path.size() + 400)
    {
      report("a message of " + std::to_string(message.size()) + " bytes: " + message);
    }
  }
}

} // namespace medial::fuzz
