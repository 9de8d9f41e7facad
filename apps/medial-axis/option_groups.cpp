#include "option_groups.h"

#include "command_line.h"
#include "device_listing.h"
#include "length.h"
#include "option_names.h"
#include "validators.h"

#include <cmath>
#include <cstdio>

namespace medial::app
{
namespace
{

constexpr double kMaxBand = 1000.0;

CLI::Validator length()
{
  return CLI::Validator(
    [](std::string& word)
    {
      return parseLength(word)
        ? std::string()
        : word + " is not a length >= 0 in the mesh's units, such as 0.5, or a share, such as 2%";
    },
    "");
}

CLI::Validator resolution()
{
  return CLI::Validator(
    [](std::string& word)
    {
      return word == kAutoResolution
        ? std::string()
        : within<int>("[2, 8192] or auto",
            [](int n) { return n >= kMinResolution && n <= kMaxDimension; })(word);
    },
    "");
}

constexpr const char* kOutputs = "Outputs";

void addAxisFiles(CLI::App& app, OptionTexts& texts)
{
  app
    .add_option("-o,--output", texts.output,
      "medial axis: .vtp, .ply, .obj or .ma; by several processes also .pvtp, pieces named "
      "<FILE's name>_0.vtp and so on")
    ->option_text("FILE")
    ->group(kOutputs);
  app
    .add_option("--curves", texts.curves,
      "polylines where the sheets of the axis meet (seams), where they end (rims), and where the "
      "axis is a curve; the cell array AxisFeature tells them apart; not for --representation "
      "points")
    ->option_text("FILE.vtp")
    ->group(kOutputs);
  app
    .add_option("--skeleton", texts.skeleton,
      "centrelines, the network of curves within the solid: a polyline for every branch, with the "
      "points' Radius, ArcLength, Degree and Tangent and the branches' Length, Kind and radii; "
      "with "
      "--topology preserve, on the inside")
    ->option_text("FILE.vtp")
    ->group(kOutputs);
  app
    .add_option("--skeleton-table", texts.skeletonTable,
      "one line for every branch of the skeleton: kind, length, radii and both ends")
    ->option_text("FILE.csv")
    ->group(kOutputs);
}

void addFieldFiles(CLI::App& app, OptionTexts& texts, Options& options)
{
  app
    .add_option("--field", texts.field,
      "distance field: .vti, one file, or .pvti, pieces of 64 slices "
      "named <FILE's name>_0.vti and so on; the distance alone as .nrrd, .mha or .nii.gz, and "
      "what is near the surface as .vdb; written "
      "while it is computed, so it may be larger than memory")
    ->option_text("FILE")
    ->group(kOutputs);
  app
    .add_option("--field-arrays", texts.fieldArrays,
      "what the --field file holds besides the distance: closest_point, closest_cell, "
      "closest_feature and closest_site, separated by commas, or distance for nothing else; 29 "
      "bytes per grid point with all of them, 4 with the distance alone; default all")
    ->option_text("LIST")
    ->needs("--field")
    ->group(kOutputs);
  app
    .add_option("--band", options.band,
      "how far from the surface a .vdb field keeps distances, in grid points, in [1, 1000]; "
      "default 3")
    ->option_text("W")
    ->check(within<double>("[1, 1000]", [](double w) { return w >= 1.0 && w <= kMaxBand; }))
    ->needs("--field")
    ->group(kOutputs);
}

void addThicknessFiles(CLI::App& app, OptionTexts& texts)
{
  app
    .add_option("--local-thickness", texts.localThickness,
      "image with the diameter of the largest ball inside the solid that contains each grid point, "
      "in world units, 0 outside; with --side exterior the separation, 0 inside; with both, the "
      "separation as a negative number; .vti, .nrrd, .mha or .nii.gz, written while it is computed")
    ->option_text("FILE")
    ->group(kOutputs);
  app
    .add_option("--histogram", texts.histogram,
      "picture of the distribution of local thickness, with mean and standard deviation: how many "
      "percent of the grid points have which value, in world units; needs no display")
    ->option_text("FILE.png")
    ->needs("--local-thickness")
    ->group(kOutputs);
  app
    .add_option("--thickness", texts.thickness,
      "input surface with the point array Thickness and the cell array of the same name, in world "
      "units, float32; NaN where there is none; see --thickness-method; uses --angle and --side, "
      "but no grid: it is exact; .vtp; by several processes also .pvtp, pieces named <FILE's "
      "name>_0.vtp and so on, of triangles with InputCell")
    ->option_text("FILE")
    ->group(kOutputs);
  app
    .add_option("--thickness-image", texts.thicknessImage,
      "picture of the surface coloured by thickness in world units, grey where there is none; "
      "large triangles get values inside as well; regions beyond limits are red and numbered")
    ->option_text("FILE.png")
    ->group(kOutputs);
  app
    .add_option("--thin-regions", texts.thinRegions,
      "triangles whose thickness is beyond --min-thickness or --max-thickness, with the cell "
      "arrays Region (as numbered in the table), Thickness and InputCell")
    ->option_text("FILE.vtp")
    ->group(kOutputs);
}

void addViewsAndReport(CLI::App& app, OptionTexts& texts, Options& options)
{
  app
    .add_option("--image", texts.image,
      "picture of the axis, or with --skeleton of the skeleton, in the translucent surface, with "
      "file, settings and scale; parts less than a fifth as thick as wide are also shown edge-on; "
      "needs no display")
    ->option_text("FILE.png")
    ->group(kOutputs);
  app
    .add_option("--html", texts.html,
      "page for browsers that shows axis and surface, with a slider for the separation angle; "
      "needs no server and no network; only in builds with vtk.js")
    ->option_text("FILE.html")
    ->group(kOutputs);
  app
    .add_option("--report", texts.report,
      "machine-readable result: mesh, parameters, grid, device, seconds of each phase, counts, "
      "topology, coverage; - for standard output, instead of the summary")
    ->option_text("FILE.json")
    ->group(kOutputs);
  app
    .add_flag("--coverage", options.coverage,
      "say in the summary, too, how much of the surface is farther than a voxel's diagonal from "
      "what an interior axis describes; with neither this nor --report a bound is enough, and a "
      "note appears if it is too much")
    ->group(kOutputs);
}

} // namespace

void addOutputOptions(CLI::App& app, OptionTexts& texts, Options& options)
{
  addAxisFiles(app, texts);
  addFieldFiles(app, texts, options);
  addThicknessFiles(app, texts);
  addViewsAndReport(app, texts, options);
}

void addGridOptions(CLI::App& app, OptionTexts& texts, Options& options)
{
  const std::string group = "Grid";
  CLI::Option* byNumber =
    app
      .add_option("--resolution", texts.resolution,
        "number of grid points along the longest axis of the padded bounds, in [2, 8192]; "
        "default 256; or auto, 128 to 512 of them, so that four lie in the radius of the "
        "skeleton's thinnest branch, as found on coarser grids")
      ->option_text("N")
      ->check(resolution())
      ->group(group);
  app
    .add_option("--spacing", texts.spacing,
      "distance between neighbouring grid points in world units, > 0; instead of --resolution")
    ->option_text("H")
    ->check(within<double>("(0, infinity)", [](double h) { return std::isfinite(h) && h > 0.0; }))
    ->excludes(byNumber)
    ->group(group);
  app
    .add_option("--padding", options.padding,
      "margin around the mesh as a fraction of the diagonal of its bounds, in [0, 10]; "
      "default 0.05")
    ->option_text("F")
    ->check(within<double>("[0, 10]", [](double f) { return f >= 0.0 && f <= kMaxPadding; }))
    ->group(group);
}

void addAxisOptions(CLI::App& app, OptionTexts& texts, Options& options)
{
  const std::string group = "Medial axis";
  app
    .add_option("--angle", options.angle,
      "minimum separation angle theta between the directions to the two closest points, in "
      "degrees, in (0, 180); smaller values keep more of the axis and more noise; default 60")
    ->option_text("DEG")
    ->check(within<double>("(0, 180)", [](double a) { return a > 0.0 && a < 180.0; }))
    ->group(group);
  app
    .add_option("--lambda", texts.lambda,
      "minimum lambda, half the distance between the two closest points, in world units or as L% "
      "of the diagonal of the mesh's bounds, >= 0; removes the sheets that noise of this size "
      "causes, and those of walls thinner than twice this; default 0")
    ->option_text("L[%]")
    ->check(length())
    ->group(group);
  app
    .add_option("--min-radius", texts.minRadius,
      "minimum radius of the medial balls, in world units or as R% of the diagonal, >= 0; "
      "default 0")
    ->option_text("R[%]")
    ->check(length())
    ->group(group);
  addSideOption(app, texts.side, group);
  app
    .add_option("--representation", texts.representation,
      "surface (dual mesh), faces (voxel faces) or points; default surface")
    ->option_text("KIND")
    ->check(oneOf(representationNames()))
    ->group(group);
  app
    .add_option("--max-spheres", options.maxSpheres,
      "compact connected axis: at most N balls, joined by lines and triangles, that describe the "
      "shape best, in [0, 2147483647]; not for --representation points; 0 for no limit; default 0")
    ->option_text("N")
    ->check(within<int>("[0, 2147483647]", [](int n) { return n >= 0; }))
    ->group(group);
  app
    .add_option("--topology", texts.topology,
      "selected: what theta selects, in as many components as that gives; preserve: with the "
      "components, tunnels and cavities of the solid at this resolution, whatever theta is; needs "
      "--representation surface or faces, and 10 bytes per grid point; default selected")
    ->option_text("KIND")
    ->check(oneOf(topologyNames()))
    ->group(group);
  addSignOption(app, texts.sign, group);
}

void addSkeletonOptions(CLI::App& app, Options& options)
{
  const std::string group = "Skeleton";
  app
    .add_option("--min-branch", options.minBranch,
      "minimum length of a branch with a free end, as a multiple of the radius where it leaves the "
      "others, >= 0; loops stay; default 1")
    ->option_text("X")
    ->check(within<double>("[0, infinity)", [](double x) { return std::isfinite(x) && x >= 0.0; }))
    ->group(group);
  app
    .add_flag_callback(
      "--no-smooth", [&options] { options.smooth = false; },
      "leave the branches on points of the axis, where they zigzag by a voxel")
    ->group(group);
}

void addThicknessOptions(CLI::App& app, OptionTexts& texts)
{
  const std::string group = "Thickness";
  const auto positive = []
  {
    return CLI::Validator(
      [](std::string& word)
      {
        const auto found = parseLength(word);
        return found && found->value > 0.0
          ? std::string()
          : word + " is not a length > 0 in the mesh's units, such as 0.5, or a share, such as 2%";
      },
      "");
  };
  app
    .add_option("--thickness-method", texts.thicknessMethod,
      "ball: twice the radius of the medial ball that touches the place, 0 on convex edges that "
      "bend by theta or more; ray: the distance along the inward normal to the opposite surface; "
      "wall: the diameter of the ball that also touches the opposite wall, with a separation angle "
      "of at least 120; near edges, that of the nearest place with such a ball; default ball, or "
      "wall if there are limits")
    ->option_text("METHOD")
    ->check(oneOf(thicknessMethodNames()))
    ->group(group);
  app
    .add_option("--min-thickness", texts.minThickness,
      "list the regions that are thinner than this, in world units or as L% of the diagonal of the "
      "mesh's bounds, > 0; the exit code is 1 if there are any; convex edges and corners do not "
      "count")
    ->option_text("L[%]")
    ->check(positive())
    ->group(group);
  app
    .add_option("--max-thickness", texts.maxThickness,
      "the same for regions that are thicker than this; above --min-thickness")
    ->option_text("L[%]")
    ->check(positive())
    ->group(group);
  app
    .add_option("--max-edge", texts.maxEdge,
      "divide triangles, for thickness only, until no edge is longer than this, in world units or "
      "as L% of the diagonal, >= 0; 0 divides none; smaller thin regions may be missed; default 0, "
      "or 2% if there are limits")
    ->option_text("L[%]")
    ->check(length())
    ->group(group);
}

void addRunOptions(CLI::App& app, OptionTexts& texts, Options& options)
{
  const std::string group = "Run";
  addThreadsOption(app, options.threads, group);
  app
    .add_option("--memory", options.memoryMiB,
      "upper bound on the memory for slabs, in MiB, >= 64; 0 chooses one; default 0")
    ->option_text("MiB")
    ->check(within<int>("[" + std::to_string(kMinMemoryMiB) + ", 2147483647] and not 0",
      [](int m) { return m == 0 || m >= kMinMemoryMiB; }))
    ->group(group);
  addEngineOption(app, texts.engine, group);
  addDeviceOptions(app, options.device, group);
  app
    .add_flag_callback(
      "--list-devices",
      []
      {
        std::printf("%s", deviceListing(listDevices()).c_str());
        throw CLI::Success();
      },
      "list what OpenGL can compute on, and what is refused and why, and exit")
    ->group(group);
  addQuietOption(app, options.quiet, group);
}

} // namespace medial::app
