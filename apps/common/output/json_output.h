#pragma once

#include <filesystem>
#include <functional>
#include <string>

// Results that a program writes as JSON, into a file or on standard output.
namespace medial::app
{

/// Checks the name of such a file: .json, or kStandardOutput.
/// @param option that has it; may be empty.
/// @throws Failure Usage.
void checkJsonName(const char* option, const std::filesystem::path& path);

/// Prints what a program has for standard output: JSON if that goes there, or else the table unless
/// the user wants none.
/// @throws Failure NoSpace.
void printResult(const std::filesystem::path& json, bool quiet,
  const std::function<std::string()>& makeJson, const std::function<void()>& printTable);

} // namespace medial::app
