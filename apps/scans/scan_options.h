#pragma once

#include "scan_input.h"

#include <CLI/CLI.hpp>

#include <filesystem>

// Scans as the input of a program.
namespace medial::app
{

/// What the help says of an input that may be a scan, after what it says of meshes.
inline constexpr char kScanInput[] =
  "; scan, with --isovalue or --label: .nrrd, .mha, .mhd, .nii, .nii.gz or .vti";

/// Adds --isovalue, --label and --scan-smoothing in a group of their own.
void addScanOptions(CLI::App& app, ScanSurface& wanted);

/// @throws Failure Usage if a scan has no wanted surface, or a mesh has one.
void checkScanOptions(const std::filesystem::path& path, const ScanSurface& wanted);

} // namespace medial::app
