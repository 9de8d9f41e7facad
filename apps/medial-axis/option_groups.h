#pragma once

#include "options.h"

#include <CLI/CLI.hpp>

#include <string>

namespace medial::app
{

/// The word in place of a number for --resolution.
constexpr const char* kAutoResolution = "auto";

/// What the user typed, before it becomes values of Options.
struct OptionTexts
{
  std::string input, output, curves, skeleton, skeletonTable, field, localThickness, histogram,
    thickness, thicknessImage, thinRegions, image, html, report;
  std::string fieldArrays;
  std::string thicknessMethod, minThickness, maxThickness, maxEdge;
  std::string lambda = "0";
  std::string minRadius = "0";
  std::string side = "interior";
  std::string representation = "surface";
  std::string topology = "selected";
  std::string sign = "auto";
  std::string engine = "auto";
  std::string resolution;
  double spacing = 0.0;
};

///@{
/// Adds the options of one group of the help to the program. What is typed goes to `texts`, numbers
/// to `options`; both must outlive the parsing.
void addOutputOptions(CLI::App& app, OptionTexts& texts, Options& options);
void addGridOptions(CLI::App& app, OptionTexts& texts, Options& options);
void addAxisOptions(CLI::App& app, OptionTexts& texts, Options& options);
void addSkeletonOptions(CLI::App& app, Options& options);
void addThicknessOptions(CLI::App& app, OptionTexts& texts);
void addRunOptions(CLI::App& app, OptionTexts& texts, Options& options);
///@}

} // namespace medial::app
