#pragma once

#include "files/scans/scan_reader.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>

namespace medial::files
{

/// Which surface of a scan is wanted: exactly one of isovalue and label.
struct ScanSurface
{
  std::optional<double> isovalue; ///< the surface where grey values are this, interpolated
  std::optional<long long> label; ///< the boundary of the voxels that have this value
  std::optional<int> smoothing;   ///< iterations of the windowed sinc filter; none: by default

  /// Iterations where the user gives none: labels have steps, grey values have not.
  static constexpr int kOfLabels = 20;
  static constexpr int kOfGreyValues = 0;
  static constexpr int kMaxIterations = 1000;

  int iterations() const;
};

/// The closed surface of a solid in a scan, in physical space; its normals lead outwards. What
/// touches the border of the image is closed there: outside is what most voxels of the border are,
/// or if all of these are NaN, most of those next to NaN. VTK's flying edges make the surface, and
/// its windowed sinc filter smooths it in units of voxels, so that thick slices are smoothed as far
/// as thin ones. Parts of a label that are one voxel wide, and gaps of that width, are not
/// smoothed: they would vanish.
///
/// @param path of the scan, for messages.
/// @throws Error InvalidInput naming the file: a label that does not occur (the message lists those
///   that do), an isovalue that no surface has (it has the range of values).
vtkSmartPointer<vtkPolyData> extractSurface(const Scan& scan, const ScanSurface& wanted,
  const std::filesystem::path& path);

} // namespace medial::files
