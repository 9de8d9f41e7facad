#include "summary.h"

#include "coverage_policy.h"
#include "number_text.h"
#include "option_names.h"
#include "output/standard_output.h"
#include "region_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>

namespace medial::app
{
namespace
{

void printMesh(const Options& options, const Result& result)
{
  const MeshFigures& mesh = result.meshFigures;
  const auto components = static_cast<long long>(mesh.components);
  std::printf("mesh      %s: %zu triangle%s, %zu vertices, %lld component%s, %s",
    options.input.c_str(), mesh.triangles, mesh.triangles == 1 ? "" : "s", mesh.points, components,
    components == 1 ? "" : "s", mesh.closed ? "closed" : "not closed");
  if (mesh.degenerateTriangles > 0)
  {
    std::printf(", %lld without area", static_cast<long long>(mesh.degenerateTriangles));
  }
  std::printf("\n");
}

void printGrid(const Result& result)
{
  const Grid& grid = result.grid;
  std::printf("grid      %d x %d x %d points, spacing %.4g, sign: %s", grid.dimensions[0],
    grid.dimensions[1], grid.dimensions[2], grid.spacing[0], nameOf(result.sign).c_str());
  if (result.chosenResolution && std::isfinite(result.chosenResolution->thinnestRadius))
  {
    std::printf(", thinnest branch: radius %.4g", result.chosenResolution->thinnestRadius);
  }
  std::printf("\n");
}

void printEngine(const RunStatistics& statistics)
{
  std::printf("engine    %s", nameOf(statistics.engine).c_str());
  if (statistics.engine != Engine::Processor)
  {
    std::printf(" on %s%s", statistics.device->renderer.c_str(),
      statistics.device->software ? " (software)" : "");
  }
  std::printf("\n");
}

std::string thicknessName(const Options& options)
{
  const ThicknessMethod method = thicknessOptions(options).method;
  return nameOf(options.side) +
    (method == ThicknessMethod::Ball ? std::string() : " (" + nameOf(method) + ")");
}

std::string counted(std::int64_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void printSkeleton(const Skeleton& skeleton)
{
  const CellTopology topology = topologyOf(skeleton);
  double length = 0.0;
  for (const SkeletonBranch& branch : skeleton.branches)
  {
    length += branch.length;
  }
  const auto branches = static_cast<std::int64_t>(skeleton.branches.size());
  std::printf("skeleton  %s, %s, %s, %s, length %.4g, in %.2f s\n",
    counted(branches, "branch", "branches").c_str(),
    counted(skeleton.junctions(), "junction", "junctions").c_str(),
    counted(topology.genus, "loop", "loops").c_str(),
    counted(topology.components, "component", "components").c_str(), length, skeleton.seconds);
}

void printLocalThickness(const char* name, const char* side,
  const std::optional<LocalThicknessSummary>& summary)
{
  if (summary && summary->points == 0)
  {
    std::printf("local     %s: no grid point lies %s the surface\n", name, side);
  }
  else if (summary)
  {
    std::printf("local     %s: mean %.4g, standard deviation %.4g, max %.4g at %lld points\n", name,
      summary->mean, summary->standardDeviation, summary->max,
      static_cast<long long>(summary->points));
  }
}

void printSeconds(const RunStatistics::Seconds& run, const AppSeconds& app)
{
  const std::pair<const char*, double> phases[] = { { "read", app.read },
    { "prepare", app.prepare }, { "sites", run.sites }, { "sign", run.sign }, { "cull", run.cull },
    { "polygons", run.polygons }, { "draw", run.draw }, { "resolve", run.resolve },
    { "medial", run.medial }, { "measure", app.measure }, { "skeleton", app.skeleton },
    { "thickness", app.thickness }, { "pictures", app.pictures }, { "write", app.write } };
  constexpr double kShown = 0.005; // less would be 0.00
  std::printf("seconds   ");
  for (const auto& [name, seconds] : phases)
  {
    if (seconds >= kShown)
    {
      std::printf("%s %.2f, ", name, seconds);
    }
  }
  std::printf("total %.2f\n", app.total);
}

void printOutputs(const Options& options, const MedialAxis& axis, const OutputNotes& notes)
{
  printFile(options.output,
    "medial axis, " + std::to_string(axis.points.size()) + " points, " +
      std::to_string(axis.cellCount()) + " cells");
  printFile(options.curves, "curves of the axis, " + std::to_string(notes.curves) + " polylines");
  printFile(options.skeleton, "skeleton");
  printFile(options.skeletonTable, "table of the skeleton's branches");
  printFile(options.field, "distance field");
  printFile(options.localThickness, "local thickness");
  printFile(options.histogram, "distribution of local thickness");
  printFile(options.thickness, "surface with thickness");
  printFile(options.thicknessImage, "picture of thickness");
  printFile(options.thinRegions, "regions beyond the limits of thickness");
  printFile(options.image,
    options.wantsSkeleton() ? "picture of skeleton and surface" : "picture of axis and surface");
  printFile(options.html, "page with axis and surface");
  printFile(options.report, "report of the run");
}

// Why an axis is empty.
std::string whatIsMissing(const Options& options)
{
  std::ostringstream text;
  text << "no point of the grid has a separation angle of " << options.angle << " degrees";
  const auto append = [&](const char* name, const Length& min)
  {
    if (min.value > 0.0)
    {
      text << " and a " << name << " of " << min.value << (min.percent ? " %" : "");
    }
  };
  append("lambda", options.lambda);
  append("radius", options.minRadius);
  text << " or more";
  return text.str();
}

void printEngineNote(const RunStatistics& statistics)
{
  if (!statistics.note.empty())
  {
    std::fprintf(stderr, "medial-axis: note: %s\n", statistics.note.c_str());
  }
}

void printSideNote(const Options& options, const SignReport& sign, Side side)
{
  if (side == options.side)
  {
    return;
  }
  const bool closable = options.signMethod == SignMethod::Auto && sign.holes > 0;
  std::fprintf(stderr,
    "medial-axis: note: %s: the distance is unsigned (%s), so the axis is that of both sides%s\n",
    options.input.c_str(), sign.reason.c_str(),
    closable ? "; --sign winding tells them apart as if the holes were closed" : "");
}

void printPageNotes(const Options& options, const OutputNotes& notes)
{
  for (const std::string& note : notes.page)
  {
    std::fprintf(stderr, "medial-axis: note: %s: to keep the page small %s\n", options.html.c_str(),
      note.c_str());
  }
}

void printSimplificationNote(const Options& options, const MedialAxis& axis)
{
  const SimplificationStatistics& done = axis.simplification;
  const auto components = static_cast<long long>(done.components);
  if (done.dropped > 0)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: --max-spheres %d is below the number of components of the axis, "
      "%lld; the %lld smallest were left out\n",
      options.input.c_str(), options.maxSpheres, components + static_cast<long long>(done.dropped),
      static_cast<long long>(done.dropped));
  }
  else if (done.forced > 0)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: --max-spheres %d closes holes of the shape: fewer balls than its "
      "topology needs\n",
      options.input.c_str(), options.maxSpheres);
  }
}

void printSimplification(const MedialAxis& axis)
{
  const SimplificationStatistics& done = axis.simplification;
  if (done.inputPoints > 0)
  {
    std::printf("simplified %lld points in %lld component%s to %lld in %lld, %.2f s\n",
      static_cast<long long>(done.inputPoints), static_cast<long long>(done.inputComponents),
      done.inputComponents == 1 ? "" : "s", static_cast<long long>(axis.points.size()),
      static_cast<long long>(done.components), done.seconds);
  }
}

void printResolutionNote(const Options& options, const SkeletonResolution& chosen)
{
  if (chosen.needed > chosen.resolution)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: the thinnest branch has a radius of %.4g, which needs --resolution "
      "%d; auto takes at most %d\n",
      options.input.c_str(), chosen.thinnestRadius, chosen.needed, kMaxSkeletonResolution);
  }
}

// Where the grid is coarser than SKELETON.md asks for.
void printBranchNote(const Options& options, const Result& result)
{
  const auto& spacing = result.grid.spacing;
  const double widest = *std::max_element(spacing.begin(), spacing.end());
  const double radius = thinnestRadius(*result.skeleton);
  if (radius < widest)
  {
    const int needed = neededResolution(*result.skeleton, result.mesh.bounds(), options.padding);
    std::fprintf(stderr,
      "medial-axis: note: %s: the thinnest branch has a radius of %.4g, less than the distance of "
      "grid points, %.4g: branches may be missing or stray; it needs %s\n",
      options.input.c_str(), radius, widest,
      options.spacing ? ("--spacing " + roundedText(0.25 * radius, 3)).c_str()
                      : ("--resolution " + std::to_string(needed)).c_str());
  }
}

/// The sum of the genera of a closed surface's components.
std::int64_t genusOf(const Result& result)
{
  const IncidenceLists& edges = result.connectivity.pointEdges;
  std::int64_t characteristic = static_cast<std::int64_t>(result.mesh.triangles.size()) -
    static_cast<std::int64_t>(result.connectivity.edges.size());
  for (int point = 0; point < edges.rows(); ++point)
  {
    characteristic += edges.size(point) > 0 ? 1 : 0;
  }
  return result.connectivity.components - characteristic / 2;
}

// Where the solid is narrower than the grid shows, and the mesh tells that something is missing.
void printCutNote(const Options& options, const Result& result)
{
  const MeshFigures& mesh = result.meshFigures;
  if (options.side != Side::Interior || !mesh.closed || !mesh.manifold)
  {
    return;
  }
  const CellTopology topology = topologyOf(*result.skeleton);
  std::string found;
  if (topology.components > mesh.components)
  {
    found = "falls into " + std::to_string(topology.components) +
      " components, while the mesh has " + std::to_string(mesh.components);
  }
  else if (const std::int64_t genus = genusOf(result);
           mesh.components == 1 && topology.genus < genus)
  {
    found = "has " + counted(topology.genus, "loop", "loops") + ", while the solid has " +
      std::to_string(genus);
  }
  if (!found.empty())
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: the skeleton %s: the grid may miss what is narrower than a voxel; a "
      "finer one would show it\n",
      options.input.c_str(), found.c_str());
  }
}

void printSkeletonNote(const Options& options, const Skeleton& skeleton)
{
  if (skeleton.openedCavities > 0)
  {
    std::fprintf(stderr, "medial-axis: note: %s: curves cannot enclose cavities: %s been opened\n",
      options.input.c_str(),
      counted(skeleton.openedCavities, "sheet around one has", "sheets around them have").c_str());
  }
}

std::string uncoveredText(const AxisCoverage& coverage)
{
  return roundedText(100.0 * coverage.uncoveredShare, 3) +
    " % of the surface is farther than a voxel's diagonal, " + roundedText(coverage.reach, 4) +
    ", from what the axis describes";
}

// Where parts are left out, and which spacing would catch them.
std::string placesOf(const Options& options, const Result& result)
{
  std::ostringstream text;
  const char* separator = ", near ";
  for (const UncoveredPlace& place : result.coverage->places)
  {
    const auto& [x, y, z] = place.point;
    text << separator << "(" << x << ", " << y << ", " << z << ")";
    separator = ", ";
  }
  if (const std::optional<double> spacing = catchingSpacing(result, options))
  {
    text << "; --spacing " << *spacing << " would catch the walls there";
  }
  return text.str();
}

void printIdleOptions(const Options& options)
{
  for (const Options::Idle& option : options.idle)
  {
    std::fprintf(stderr, "medial-axis: note: %s has no effect, since no output needs %s\n",
      option.name, option.missing);
  }
}

void printLimitNote(const Options& options, double diagonal)
{
  const std::optional<double> least = thicknessLimits(options, diagonal).min;
  if (least && *least > diagonal)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: no place can be as thick as --min-thickness %.6g: the diagonal of "
      "the mesh is %.6g\n",
      options.input.c_str(), *least, diagonal);
  }
}

void printCoverageNote(const Options& options, const Result& result)
{
  const AxisCoverage& coverage = *result.coverage;
  if (coverage.uncoveredShare >= kNoticeableShare)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: %s: the grid, the selection or --max-spheres leaves parts out%s\n",
      options.input.c_str(), uncoveredText(coverage).c_str(), placesOf(options, result).c_str());
  }
}

} // namespace

void printSignNotes(const Options& options, const SignReport& sign, Side side)
{
  // A result that is not what was asked for is no matter of taste.
  if (options.wantsAxis() && (!options.quiet || options.sideGiven))
  {
    printSideNote(options, sign, side);
  }
  if (options.wantsAxis() && !options.quiet && sign.method == SignMethod::Winding && sign.holes > 0)
  {
    std::fprintf(stderr, "medial-axis: note: %s: %s, to tell inside from outside\n",
      options.input.c_str(), sign.reason.c_str());
  }
}

void printNotes(const Options& options, const Result& result, const OutputNotes& notes)
{
  if (options.quiet)
  {
    printSignNotes(options, result.statistics.sign, result.axis.side);
    return;
  }
  printEngineNote(result.statistics);
  printIdleOptions(options);
  printSignNotes(options, result.statistics.sign, result.axis.side);
  if (options.wantsAxis() && result.axisPoints == 0)
  {
    std::fprintf(stderr, "medial-axis: note: %s: %s\n", options.input.c_str(),
      whatIsMissing(options).c_str());
  }
  if (result.coverage)
  {
    printCoverageNote(options, result);
  }
  if (result.chosenResolution)
  {
    printResolutionNote(options, *result.chosenResolution);
  }
  if (result.skeleton)
  {
    if (!result.chosenResolution)
    {
      printBranchNote(options, result);
    }
    printCutNote(options, result);
    printSkeletonNote(options, *result.skeleton);
  }
  if (options.hasThicknessLimits())
  {
    printLimitNote(options, result.meshFigures.diagonal);
  }
  printPageNotes(options, notes);
  printSimplificationNote(options, result.axis);
}

void printThickness(const Options& options, const Thickness& thickness)
{
  if (std::isnan(thickness.median))
  {
    std::printf("thickness %s: none at any point, in %.2f s\n", thicknessName(options).c_str(),
      thickness.seconds);
    return;
  }
  std::printf("thickness %s: min %.4g, median %.4g, max %.4g, ", thicknessName(options).c_str(),
    thickness.min, thickness.median, thickness.max);
  std::printf("90 %% of the points from %.4g to %.4g, ", thickness.percentile5,
    thickness.percentile95);
  if (thickness.shareWithout() > 0.0)
  {
    std::printf("no value at %.3g %% of the points, ", 100.0 * thickness.shareWithout());
  }
  std::printf("in %.2f s\n", thickness.seconds);
}

void printCoverage(const std::optional<AxisCoverage>& coverage)
{
  if (!coverage)
  {
    std::printf("coverage  is that of an interior axis alone\n");
    return;
  }
  std::printf("coverage  %s\n", uncoveredText(*coverage).c_str());
}

void printSummary(const Options& options, const Result& result, const OutputNotes& notes,
  const AppSeconds& seconds)
{
  printMesh(options, result);
  if (options.wantsGrid())
  {
    printGrid(result);
    printEngine(result.statistics);
  }
  if (result.thickness)
  {
    printThickness(options, *result.thickness);
  }
  if (result.skeleton)
  {
    printSkeleton(*result.skeleton);
  }
  if (options.hasThicknessLimits())
  {
    std::printf("%s", regionTable(result.regions).c_str());
  }
  if (result.localThickness)
  {
    printLocalThickness("thickness", "inside", result.localThickness->thickness);
    printLocalThickness("separation", "outside", result.localThickness->separation);
  }
  if (options.coverage)
  {
    printCoverage(result.coverage);
  }
  printSeconds(result.statistics.seconds, seconds);
  printSimplification(result.axis);
  printOutputs(options, result.axis, notes);
}

} // namespace medial::app
