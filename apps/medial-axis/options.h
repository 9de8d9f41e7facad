#pragma once

#include "device_options.h"
#include "length.h"
#include "scan_input.h"
#include "volumes/field_layout.h"

#include "medial/compute_medial_axis.h"
#include "medial/local_thickness.h"
#include "medial/skeleton.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace medial::app
{

/// The command line, checked as far as that is possible without the mesh. Empty paths are outputs
/// that are not wanted.
struct Options
{
  std::filesystem::path input;         ///< a mesh, or a scan
  ScanSurface scan;                    ///< which surface to take from a scan
  std::filesystem::path output;        ///< .vtp, .pvtp, .ply, .obj or .ma
  std::filesystem::path curves;        ///< .vtp
  std::filesystem::path skeleton;      ///< .vtp
  std::filesystem::path skeletonTable; ///< .csv
  std::filesystem::path field;         ///< .vti, .pvti, .nrrd, .mha or .nii.gz
  FieldSelection fieldArrays = kAllFieldArrays;
  std::optional<double> band;                         ///< of a .vdb field, in grid points
  std::filesystem::path localThickness;               ///< as field
  std::filesystem::path histogram;                    ///< .png
  std::filesystem::path thickness;                    ///< .vtp or .pvtp
  std::filesystem::path thicknessImage;               ///< .png
  std::filesystem::path thinRegions;                  ///< .vtp
  std::filesystem::path image;                        ///< .png
  std::filesystem::path html;                         ///< .html
  std::filesystem::path report;                       ///< .json
  bool coverage = false;                              ///< whether the summary has that of the axis
  std::optional<int> resolution = kDefaultResolution; ///< empty: what the skeleton needs
  std::optional<double> spacing;                      ///< instead of resolution
  double padding = kDefaultPadding;
  double angle = kDefaultAngle;
  std::optional<ThicknessMethod> thicknessMethod;
  std::optional<Length> minThickness;
  std::optional<Length> maxThickness;
  std::optional<Length> maxEdge; ///< of the surface whose thickness is computed; 0: as it is
  Length lambda;
  Length minRadius;
  Side side = Side::Interior;
  bool sideGiven = false; ///< whether the command line has --side
  Representation representation = Representation::Surface;
  int maxSpheres = 0;                     ///< 0: no limit
  Topology topology = Topology::Selected; ///< Preserve wherever a skeleton is wanted
  double minBranch = kDefaultMinBranch;
  bool smooth = true; ///< the skeleton
  SignMethod signMethod = SignMethod::Auto;
  Engine engine = Engine::Auto;
  int threads = 0;
  int memoryMiB = 0;
  DeviceOptions device;
  bool quiet = false;
  /// An option given on the command line that changes nothing.
  struct Idle
  {
    const char* name;
    const char* missing; ///< what it is for, and no output needs
  };
  std::vector<Idle> idle;

  /// Whether thickness must be within limits.
  bool hasThicknessLimits() const { return minThickness || maxThickness; }

  /// Whether the thickness of the surface is to be computed.
  bool wantsThickness() const
  {
    return !thickness.empty() || !thicknessImage.empty() || this->hasThicknessLimits();
  }

  /// Whether the skeleton is to be computed.
  bool wantsSkeleton() const { return !skeleton.empty() || !skeletonTable.empty(); }

  /// Whether a grid is needed.
  bool wantsGrid() const { return !field.empty() || !localThickness.empty() || this->wantsAxis(); }

  /// Whether a bound of the coverage is not enough.
  bool wantsWholeCoverage() const { return coverage || !report.empty(); }

  /// Whether the medial axis is to be computed: for an output, its coverage, or the figures of a
  /// report that is asked for alone.
  bool wantsAxis() const
  {
    return coverage || !output.empty() || !curves.empty() || !image.empty() || !html.empty() ||
      this->wantsSkeleton() || (field.empty() && localThickness.empty() && !wantsThickness());
  }
};

/// Reads the command line. Empty if the user asked for --help or --version; the answer is on
/// standard output then.
/// @throws Failure Usage.
std::optional<Options> parseOptions(int argc, char** argv);

///@{
/// The options as the library takes them.
/// @param diagonal of the mesh's bounds, world units.
MedialAxisOptions libraryOptions(const Options& options, double diagonal);
ThicknessOptions thicknessOptions(const Options& options);
SkeletonOptions skeletonOptions(const Options& options);
ThicknessLimits thicknessLimits(const Options& options, double diagonal);
LocalThicknessOptions localThicknessOptions(const Options& options);
///@}

} // namespace medial::app
