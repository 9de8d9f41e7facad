#pragma once

#include "options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace medial::app
{

/// The words as typed, before they become values of Options.
struct Words
{
  std::string input, output, curves, field, thickness, thicknessImage, image, html, report;
  std::string lambda = "0";
  std::string minRadius = "0";
  std::string side = "interior";
  std::string representation = "surface";
  std::string topology = "selected";
  std::string sign = "auto";
  std::string engine = "auto";
  double spacing = 0.0;
};

///@{
/// Adds the options of one group of the help to the program. What is typed goes to `words`, numbers
/// to `options`; both must outlive the parsing.
void addOutputOptions(CLI::App& app, Words& words);
void addGridOptions(CLI::App& app, Words& words, Options& options);
void addAxisOptions(CLI::App& app, Words& words, Options& options);
void addRunOptions(CLI::App& app, Words& words, Options& options);
///@}

} // namespace medial::app
