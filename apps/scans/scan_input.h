#pragma once

#include "files/scans/scan_surface.h"
#include "input/sequence.h"
#include "input/surface.h"

#include <filesystem>
#include <vector>

// Meshes, and the surfaces of scans.
namespace medial::app
{

using files::isScanFile;
using files::ScanSurface;

/// The files that are read for an input: itself, and one that the header of a scan says has its
/// values.
std::vector<std::filesystem::path> filesOfScan(const std::filesystem::path& path);

/// Reads a mesh, or the surface that is wanted of a scan.
/// @throws Failure BadInput naming the file.
Surface readSurface(const std::filesystem::path& path, const ScanSurface& wanted);

/// Reads the frames of a sequence, each as readSurface() does.
/// @throws Failure BadInput naming the file.
Sequence readSequence(const std::vector<std::filesystem::path>& inputs, const ScanSurface& wanted);

} // namespace medial::app
