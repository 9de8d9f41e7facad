#pragma once

#include "affine_transform.h"

#include "medial/proximity.h"

#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace medial::app
{

/// How one of the meshes is moved: the same in all frames, or by a file.
struct Motion
{
  std::optional<AffineTransform> transform;
  std::filesystem::path file; ///< where there is no transform
};

/// The command line of medial-proximity. Empty paths are outputs that are not wanted.
struct ProximityCommand
{
  std::vector<std::filesystem::path>
    inputs; ///< two or more: files; folders or patterns of a sequence
  bool sequence = false;
  std::map<int, Motion> motions;   ///< by the index of the mesh
  std::filesystem::path json;      ///< .json, or kStandardOutput
  std::filesystem::path contacts;  ///< .vtp or .pvd
  std::filesystem::path image;     ///< .png
  std::filesystem::path animation; ///< folder
  ProximityOptions options;        ///< without progress
  bool quiet = false;
};

/// Reads the command line. Empty if the user asked for --help or --version; the answer is on
/// standard output then.
/// @throws Failure Usage.
std::optional<ProximityCommand> parseProximityCommand(int argc, char** argv);

} // namespace medial::app
