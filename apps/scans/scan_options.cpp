#include "scan_options.h"

#include "failure.h"
#include "files/scans/scan_reader.h"
#include "validators.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

namespace medial::app
{

std::string scanInput()
{
  return "; scan, with --isovalue or --label: " + files::enumerated(files::scanExtensions());
}

void addScanOptions(CLI::App& app, ScanSurface& wanted)
{
  const std::string group = "Scan";
  CLI::Option* isovalue =
    app
      .add_option("--isovalue", wanted.isovalue,
        "take the surface where a grey image has this value; the outside is what most of the "
        "image's border belongs to")
      ->option_text("V")
      ->check(within<double>("(-infinity, infinity)", [](double v) { return std::isfinite(v); }))
      ->group(group);
  app
    .add_option("--label", wanted.label,
      "take the boundary of the voxels with this value in a label image")
    ->option_text("N")
    ->check(within<long long>("[-9223372036854775808, 9223372036854775807]",
      [](long long) { return true; }))
    ->excludes(isovalue)
    ->group(group);
  app
    .add_option("--scan-smoothing", wanted.smoothing,
      "iterations of the windowed sinc filter that smooths the surface of a scan, in [0, 1000]; "
      "default 20 for labels, 0 for isovalues")
    ->option_text("N")
    ->check(
      within<int>("[0, 1000]", [](int n) { return n >= 0 && n <= ScanSurface::kMaxIterations; }))
    ->group(group);
}

void checkScanOptions(const std::filesystem::path& path, const ScanSurface& wanted)
{
  if (isScanFile(path))
  {
    if (!wanted.isovalue && !wanted.label)
    {
      throw Failure(ExitCode::Usage,
        path.string() + " is an image: choose its surface with --isovalue V or --label N");
    }
    return;
  }
  const char* given = wanted.isovalue ? "--isovalue"
    : wanted.label                    ? "--label"
    : wanted.smoothing                ? "--scan-smoothing"
                                      : nullptr;
  if (given != nullptr)
  {
    throw Failure(ExitCode::Usage,
      std::string(given) + " needs an image (" + files::joined(files::scanExtensions(), " ") +
        "), which " + path.string() + " is not");
  }
}

} // namespace medial::app
