#pragma once

#include "output/machine.h"
#include "output/plot.h"
#include "output/table.h"
#include "output/target.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// The results of a suite.
struct SuiteReport
{
  std::string name;         ///< stem of the files
  std::string title;        ///< one line
  bool usesRenderer = true; ///< whether the page names it
  int rounds = 1;           ///< in which the methods took turns
  std::string how;          ///< what was timed; empty for whole distance fields
  std::vector<std::string> notes;
  std::vector<Row> rows;
  std::vector<Target> targets;
  std::vector<Table> tables;
  std::vector<CurvePlot> curves;
  std::vector<BarPlot> bars;
  nlohmann::json figures = nlohmann::json::object(); ///< such as fitted exponents
};

/// Writes NAME.json, NAME.md and the plots. Plots are left out, with a line on stderr, where they
/// cannot be drawn. Files that are there already are replaced when the new ones are complete.
/// @throws std::runtime_error if a file cannot be written.
void writeReport(const SuiteReport& report, const Machine& machine,
  const std::filesystem::path& folder);

} // namespace medial::benchmark
