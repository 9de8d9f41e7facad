#include "ranks/run_on_ranks.h"

#include "failure.h"
#include "grid_choice.h"
#include "input/input_file.h"
#include "library_calls.h"
#include "number_text.h"
#include "output/standard_output.h"
#include "progress_bar.h"
#include "ranks/mesh_pieces.h"
#include "ranks/rank_agreement.h"
#include "ranks/rank_input.h"
#include "ranks/rank_outputs.h"
#include "ranks/rank_result.h"
#include "ranks/rank_thickness.h"
#include "region_table.h"
#include "report.h"
#include "scan_input.h"
#include "summary.h"
#include "timer.h"
#include "volumes/field_output.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

/// Several processes compute the field, the axis and the thickness alone.
void checkOptions(const Options& options)
{
  const auto refuse = [](const std::string& message)
  { throw Failure(ExitCode::Usage, "several processes: " + message); };
  if (!options.field.empty() && extensionOf(options.field) != ".pvti")
  {
    refuse("they need --field FILE.pvti");
  }
  const std::pair<const char*, bool> others[] = { { "--local-thickness",
                                                    !options.localThickness.empty() },
    { "--thickness-image", !options.thicknessImage.empty() },
    { "--curves", !options.curves.empty() }, { "--skeleton", options.wantsSkeleton() },
    { "--image", !options.image.empty() }, { "--html", !options.html.empty() },
    { "a scan as input", isScanFile(options.input) }, { "--require-gpu", options.device.require },
    { "--verify", options.device.verify }, { "--device", !options.device.name.empty() } };
  for (const auto& [name, wanted] : others)
  {
    if (wanted)
    {
      refuse(std::string(name) + " needs a single one");
    }
  }
  if (options.engine != Engine::Auto && options.engine != Engine::Processor)
  {
    refuse("they need --engine processor");
  }
  if (isInPieces(options.input) && needsWholeForThickness(options))
  {
    throw Failure(ExitCode::Usage,
      options.input.string() + " lies in pieces: --thickness FILE.vtp needs a mesh in one file");
  }
}

/// What must be the same on every rank.
std::string textOf(const Options& options)
{
  std::string text = options.input.string() + '\n';
  for (const auto& output :
    { options.field, options.output, options.report, options.thickness, options.thinRegions })
  {
    // Pieces belong beside their index, wherever ranks run.
    const bool isFile = !output.empty() && output != kStandardOutput;
    text += (isFile ? std::filesystem::absolute(output) : output).string() + '\n';
  }
  const auto lengthOf = [](const std::optional<Length>& length)
  { return length ? std::pair(length->value, length->percent) : std::pair(-1.0, false); };
  for (const auto& length : { options.minThickness, options.maxThickness, options.maxEdge,
         std::optional(options.lambda), std::optional(options.minRadius) })
  {
    const auto& [value, isShare] = lengthOf(length);
    text += numberText(value) + (isShare ? "% " : " ");
  }
  for (const double number : { static_cast<double>(thicknessOptions(options).method),
         static_cast<double>(options.resolution.value_or(0)), options.spacing.value_or(0.0),
         options.padding, options.angle, static_cast<double>(options.maxSpheres),
         static_cast<double>(options.signMethod), static_cast<double>(options.side),
         static_cast<double>(options.representation), static_cast<double>(options.topology),
         options.quiet ? 1.0 : 0.0, options.coverage ? 1.0 : 0.0 })
  {
    text += numberText(number) + ' ';
  }
  for (const bool wanted : options.fieldArrays)
  {
    text += wanted ? '1' : '0';
  }
  return text;
}

/// @param options nothing after --help and --version.
void requireSameOptions(const std::optional<Options>& options, Communicator& communicator)
{
  const std::string own = options ? textOf(*options) : "";
  const std::vector<Message> texts = gathered(communicator, Message(own.begin(), own.end()));
  for (std::size_t rank = 1; rank < texts.size(); ++rank)
  {
    if (texts[rank] != texts.front())
    {
      throw Failure(ExitCode::Usage,
        "rank " + std::to_string(rank) +
          " has other options than rank 0, or runs in another folder");
    }
  }
}

/// Returns the parts of the grid that ranks compute.
std::vector<Extent> extentsOf(const Options& options, Communicator& communicator,
  const Share& share, const Grid& grid, ProgressBar& bar)
{
  Watch watch(bar);
  std::vector<Extent> extents;
  withFailures(options.input,
    [&]
    {
      MedialAxisOptions wanted = libraryOptions(options, share.bounds.diagonal());
      wanted.field.engine = Engine::Processor;
      wanted.field.execution.progress = &watch;
      extents = partsByWork(communicator, share.piece, grid, wanted.field,
        options.wantsAxis() && options.field.empty() ? wanted.side : Side::Both);
    });
  return extents;
}

/// @param field null if it is not wanted.
RankComputed compute(const Options& options, Communicator& communicator, const Share& share,
  const Grid& grid, const std::vector<Extent>& extents, FieldOutput* field, ProgressBar& bar)
{
  Watch watch(bar);
  MedialAxisOptions wanted = libraryOptions(options, share.bounds.diagonal());
  wanted.field.engine = Engine::Processor;
  wanted.field.execution.progress = &watch;
  RankComputed result;
  NoField nothing;
  withFailures(options.input,
    [&]
    {
      if (options.wantsAxis())
      {
        result.axis = computeMedialAxis(communicator, share.piece, grid, extents,
          field != nullptr ? static_cast<FieldSink&>(*field) : nothing, wanted, &result.counts);
      }
      else if (field != nullptr)
      {
        result.statistics = computeDistanceField(communicator, share.piece, grid,
          touchingExtent(grid, extents[communicator.rank()]), *field, wanted.field, &result.counts);
      }
    });
  if (options.wantsAxis())
  {
    result.statistics = result.axis.axis.statistics;
  }
  return result;
}

void printSummary(const Options& options, const Result& result, double seconds)
{
  std::int64_t triangles = 0;
  std::int64_t held = 0;
  std::int64_t cells = 0;
  for (const RankFigures& rank : result.ranks)
  {
    triangles += rank.counts.ownTriangles;
    held = std::max(held, rank.counts.heldTriangles);
    cells = std::max(cells, rank.axisCells);
  }
  if (triangles > 0)
  {
    std::printf("mesh      %lld triangles, at most %lld on a process\n",
      static_cast<long long>(triangles), static_cast<long long>(held));
  }
  const std::array<int, 3>& dimensions = result.grid.dimensions;
  if (options.wantsGrid())
  {
    std::printf("grid      %d x %d x %d, on %zu processes\n", dimensions[0], dimensions[1],
      dimensions[2], result.ranks.size());
  }
  if (options.wantsAxis())
  {
    std::printf("axis      %lld points, %lld cells, at most %lld on a process\n",
      static_cast<long long>(result.axisPoints), static_cast<long long>(result.axisCells),
      static_cast<long long>(cells));
  }
  if (options.wantsThickness())
  {
    printThickness(options, *result.thickness);
  }
  if (options.coverage)
  {
    printCoverage(result.coverage);
  }
  if (options.hasThicknessLimits())
  {
    std::printf("%s", regionTable(result.regions).c_str());
  }
  std::printf("time      %.2f s\n", seconds);
  for (const auto& [name, path] : { std::pair("field", options.field),
         std::pair("output", options.output), std::pair("thickness", options.thickness),
         std::pair("regions", options.thinRegions), std::pair("report", options.report) })
  {
    if (!path.empty())
    {
      std::printf("%-9s %s\n", name, path.c_str());
    }
  }
}

/// Tells the user, on the first rank, what was computed.
void tell(const Options& options, const Result& result, const AppSeconds& seconds)
{
  printNotes(options, result, {});
  if (options.wantsAxis() && options.maxSpheres > 0 && !options.quiet)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: --max-spheres looks at the whole axis: the first process simplified "
      "it alone\n",
      options.input.c_str());
  }
  if (options.report == kStandardOutput)
  {
    printText(makeReport(result, options, seconds));
  }
  else if (!options.quiet)
  {
    printSummary(options, result, seconds.total);
  }
}

} // namespace

std::optional<Options> agreedOptions(int argc, char** argv, Communicator& communicator)
{
  std::optional<Options> options;
  withSharedFailures(communicator,
    [&]
    {
      options = parseOptions(argc, argv);
      if (options)
      {
        checkOptions(*options);
      }
    });
  requireSameOptions(options, communicator);
  return options;
}

void runOnRanks(const Options& options, Communicator& communicator)
{
  const Timer total;
  AppSeconds seconds;
  ProgressBar bar(options.quiet || communicator.rank() > 0);
  RankOutputs outputs(options, communicator);
  bar.show(0.0, "reading");
  Share share = readShare(options, needsWholeForThickness(options), communicator);
  seconds.read = total.seconds();
  Grid grid;
  std::vector<Extent> extents;
  RankComputed computed;
  if (options.wantsGrid())
  {
    withSharedFailures(communicator, [&] { grid = gridOf(share.bounds, options); });
    extents = extentsOf(options, communicator, share, grid, bar);
    seconds.prepare = total.seconds() - seconds.read;
    outputs.begin(grid, extents);
    computed = compute(options, communicator, share, grid, extents, outputs.field(), bar);
  }
  if (options.wantsThickness())
  {
    const Timer measuring;
    computed.thickness = computeThickness(options, communicator, share, bar);
    seconds.thickness = measuring.seconds();
  }
  const Result result = resultOf(options, communicator, share, grid, extents, computed);
  seconds.measure = result.measureSeconds;
  const Timer writing;
  outputs.writeAxis(computed.axis, gatheredValues(communicator, computed.axis.axis.cellCount()));
  outputs.writeThickness(computed.thickness, result);
  seconds.write = writing.seconds();
  seconds.total = total.seconds();
  outputs.writeReport(makeReport(result, options, seconds));
  outputs.commit();
  seconds.total = total.seconds();
  bar.clear();
  withFailuresOfFirst(communicator, [&] { tell(options, result, seconds); });
  requireNoRegions(options, communicator, result);
}

} // namespace medial::app
