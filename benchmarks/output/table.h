#pragma once

#include "measurement.h"

#include <string>
#include <vector>

namespace medial::benchmark
{

/// A Markdown table: first column to the left, others to the right.
struct Table
{
  std::string title; ///< a paragraph above it; may be empty
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;

  std::string markdown() const;
};

/// Text of a number with so many significant digits; "-" for NaN.
std::string number(double value, int digits = 3);
std::string thousands(std::int64_t value); ///< 12,345
std::string dimensionsText(const Grid& grid);

/// Seconds as "0.71 (0.70-0.74)", with the number of runs where there were fewer than rounds; a
/// prediction as "~ 210, not run"; or the failure.
std::string secondsText(const MethodRun& run, int rounds);
/// The same for the method of an id; "-" where it took no part.
std::string secondsText(const Row& row, const std::string& id);

/// The mesh's name and what the reader must know of it.
std::string meshText(const Row& row);

/// The part of our seconds that goes into sites, culling and polygons; NaN without samples.
double geometryShare(const MethodRun& run);

/// One line for each mesh and method: seconds, ratio to ours, errors, memory.
Table methodTable(const std::vector<Row>& rows);

/// One line for each mesh and engine: seconds of our phases, and how much was drawn.
Table phaseTable(const std::vector<Row>& rows);

} // namespace medial::benchmark
