#pragma once

#include "input/sequence.h"
#include "input/surface.h"
#include "scan_reader.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <optional>
#include <vector>

namespace medial::app
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

  int iterations() const;
};

/// The closed surface of a solid in a scan, in physical space. What touches the border of the image
/// is closed there: outside is what most voxels of the border are. VTK's flying edges, then its
/// windowed sinc filter in units of voxels, so that thick slices are smoothed as far as thin ones.
///
/// @param path of the scan, for messages.
/// @throws Failure BadInput naming the file: a label that does not occur (the message lists those
///   that do), an isovalue that no surface has (it has the range of values).
vtkSmartPointer<vtkPolyData> extractSurface(const Scan& scan, const ScanSurface& wanted,
  const std::filesystem::path& path);

/// Reads a mesh, or the surface that is wanted of a scan.
/// @throws Failure BadInput naming the file.
Surface readSurface(const std::filesystem::path& path, const ScanSurface& wanted);

/// Reads the frames of a sequence, each as readSurface() does.
/// @throws Failure BadInput naming the file.
Sequence readSequence(const std::vector<std::filesystem::path>& inputs, const ScanSurface& wanted);

} // namespace medial::app
