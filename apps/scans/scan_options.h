#pragma once

#include "input/surface.h"
#include "scan_surface.h"

#include <filesystem>

namespace CLI
{
class App;
}

// Scans as the input of a program.
namespace medial::app
{

/// Adds --isovalue, --label and --scan-smoothing in a group of their own.
void addScanOptions(CLI::App& app, ScanSurface& wanted);

/// @throws Failure Usage if a scan has no wanted surface, or a mesh has one.
void checkScanOptions(const std::filesystem::path& path, const ScanSurface& wanted);

/// Reads a mesh, or the surface that is wanted of a scan.
/// @throws Failure BadInput naming the file.
Surface readSurface(const std::filesystem::path& path, const ScanSurface& wanted);

} // namespace medial::app
