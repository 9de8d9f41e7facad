#pragma once

#include "medial/triangle_mesh.h"

#include <filesystem>
#include <optional>
#include <string>

namespace medial::benchmark
{

/// What a method is to compute, in a file for another process of this program.
struct Problem
{
  TriangleMesh mesh;
  Grid grid;
};

/// Of the mesh only the triangles.
/// @throws std::runtime_error if the file cannot be written or read.
void writeProblem(const std::filesystem::path& file, const TriangleMesh& mesh, const Grid& grid);
Problem readProblem(const std::filesystem::path& file);

/// Bytes by which a method's first call raises the peak of resident memory, in a new process of
/// this program, so that neither earlier runs nor memory that these left count. Starting OpenGL is
/// part of it. Nothing, and a line on stderr, where that fails.
std::optional<double> peakOfFirstCall(const std::string& methodId, const TriangleMesh& mesh,
  const Grid& grid);

/// The other process: computes the problem and prints the bytes.
void answerPeak(const std::string& methodId, const std::filesystem::path& problem);

} // namespace medial::benchmark
