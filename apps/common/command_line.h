#pragma once

#include "device_options.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

// Parts of the command line that all programs share.
namespace medial::app
{

/// Gives an application its name, the text below its options, --version and --help.
void setUpCommandLine(CLI::App& app, const std::string& name, const std::string& footer);

/// Parses the command line.
/// @return false if the user asked for --help or --version; the answer is on standard output then.
/// @throws Failure Usage, also for an empty value.
bool parseCommandLine(CLI::App& app, int argc, char** argv);

///@{
/// Options of several programs. option_names.h turns the words that the user types into values.
void addSignOption(CLI::App& app, std::string& word, const std::string& group);
void addSideOption(CLI::App& app, std::string& word, const std::string& group);
void addEngineOption(CLI::App& app, std::string& word, const std::string& group);
void addThreadsOption(CLI::App& app, int& threads, const std::string& group);
void addDeviceOptions(CLI::App& app, DeviceOptions& options, const std::string& group);
void addQuietOption(CLI::App& app, bool& quiet, const std::string& group);
///@}

/// @param path of an output, empty for none.
/// @throws Failure Usage, naming the option, if its extension is not allowed.
void checkExtension(const char* option, const std::filesystem::path& path,
  const std::vector<std::string>& allowed);

} // namespace medial::app
