#pragma once

#include "scan_input.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

// Scans as the input of a program.
namespace medial::app
{

/// What the help says of an input that may be a scan, after what it says of meshes.
std::string scanInput();

/// Adds --isovalue, --label and --scan-smoothing in a group of their own.
void addScanOptions(CLI::App& app, ScanSurface& wanted);

/// @throws Failure Usage if a scan has no wanted surface, or a mesh has one.
void checkScanOptions(const std::filesystem::path& path, const ScanSurface& wanted);

} // namespace medial::app
