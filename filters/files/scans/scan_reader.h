#pragma once

#include "files/extensions.h"
#include "files/scans/scan_header.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace medial::files
{

/// An image of a solid: grey values, or labels of a segmentation.
struct Scan
{
  vtkSmartPointer<vtkImageData> image; ///< one value a voxel; point (i, j, k) lies at (i, j, k)
  ScanFrame frame{};                   ///< from there to physical space
};

/// Extensions of images.
const Extensions& scanExtensions();

/// Whether readScan() knows the extension.
bool isScanFile(const std::filesystem::path& path);

/// The file that has the values of an image, as its header says; empty if the header has them too,
/// or cannot be read.
std::filesystem::path valuesFileOf(const std::filesystem::path& path);

/// Reads an image by the extension of its file, one of scanExtensions(). What a header
/// promises is compared with the bytes that are there before memory is allocated. VTK's readers are
/// not asked: those of 9.1 read no compressed NRRD, leave out the directions of axes, and allocate
/// what a damaged header says.
///
/// @throws Error naming the file: CannotRead, also for an unknown extension, InvalidInput (see
/// parseNrrdHeader()), OutOfMemory.
Scan readScan(const std::filesystem::path& path);

} // namespace medial::files
