#include "run_on_ranks.h"

#include "axis_pieces.h"
#include "computation.h"
#include "failure.h"
#include "field_output.h"
#include "file_writer.h"
#include "input_file.h"
#include "interrupt.h"
#include "library_calls.h"
#include "progress_bar.h"
#include "rank_agreement.h"
#include "rank_input.h"
#include "scan_reader.h"
#include "summary.h"
#include "timer.h"
#include "vtp_writer.h"

#include "medial/axis_io.h"

#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

/// Several processes compute the field and the axis alone.
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
    { "thickness", options.wantsThickness() }, { "--curves", !options.curves.empty() },
    { "--skeleton", options.wantsSkeleton() }, { "--image", !options.image.empty() },
    { "--html", !options.html.empty() }, { "--report", !options.report.empty() },
    { "a scan as input", isScanFile(options.input) } };
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
}

/// What the first process computes alone; null for an axis that all compute.
const char* reasonForOne(const Options& options)
{
  return !options.wantsAxis()                ? nullptr
    : options.topology == Topology::Preserve ? "--topology preserve"
    : options.maxSpheres > 0                 ? "--max-spheres"
                                             : nullptr;
}

/// What must be the same on every rank.
std::string textOf(const Options& options)
{
  std::string text =
    options.input.string() + '\n' + options.field.string() + '\n' + options.output.string() + '\n';
  for (const double number : { static_cast<double>(options.resolution.value_or(0)),
         options.spacing.value_or(0.0), options.padding, options.angle, options.lambda.value,
         options.minRadius.value, static_cast<double>(options.maxSpheres),
         static_cast<double>(options.signMethod), static_cast<double>(options.side),
         static_cast<double>(options.representation), static_cast<double>(options.topology) })
  {
    text += std::to_string(number) + ' ';
  }
  for (const bool wanted : options.fieldArrays)
  {
    text += wanted ? '1' : '0';
  }
  return text;
}

void requireSameOptions(const Options& options, Communicator& communicator)
{
  const std::string own = textOf(options);
  const std::vector<Message> texts = gathered(communicator, Message(own.begin(), own.end()));
  for (std::size_t rank = 1; rank < texts.size(); ++rank)
  {
    if (texts[rank] != texts.front())
    {
      throw Failure(ExitCode::Usage,
        "rank " + std::to_string(rank) + " has other options than rank 0");
    }
  }
}

/// What all ranks have computed together.
struct Computed
{
  std::vector<RankCounts> counts;
  AxisPiece axis;                  ///< of this rank
  std::vector<std::int64_t> cells; ///< of the axis, on each rank
};

template <typename T>
std::vector<T> gatheredValues(Communicator& communicator, const T& own)
{
  Message message(sizeof(own));
  std::memcpy(message.data(), &own, sizeof(own));
  std::vector<T> values;
  for (const Message& received : gathered(communicator, message))
  {
    values.emplace_back();
    std::memcpy(&values.back(), received.data(), sizeof(own));
  }
  return values;
}

/// Makes a whole axis the piece of the first rank.
AxisPiece onlyPiece(MedialAxis axis)
{
  AxisPiece piece;
  piece.points = static_cast<std::int64_t>(axis.points.size());
  piece.cells = axis.cellCount();
  piece.globalPointIds.resize(axis.points.size());
  piece.globalCellIds.resize(static_cast<std::size_t>(piece.cells));
  std::iota(piece.globalPointIds.begin(), piece.globalPointIds.end(), std::int64_t{ 0 });
  std::iota(piece.globalCellIds.begin(), piece.globalCellIds.end(), std::int64_t{ 0 });
  piece.axis = std::move(axis);
  return piece;
}

/// Computes the whole axis on the first rank.
AxisPiece axisOfOne(Communicator& communicator, const Share& share, const Grid& grid,
  const MedialAxisOptions& wanted)
{
  AxisPiece piece;
  agree(communicator,
    [&]
    {
      if (communicator.rank() == 0)
      {
        piece = onlyPiece(computeMedialAxis(share.whole, grid, wanted));
      }
    });
  return piece;
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
      DistanceFieldOptions wanted = libraryOptions(options, share.bounds.diagonal()).field;
      wanted.engine = Engine::Processor;
      wanted.execution.progress = &watch;
      extents = reasonForOne(options) == nullptr
        ? partsByWork(communicator, share.piece, grid, wanted)
        : partsOfGrid(grid, communicator.size());
    });
  return extents;
}

/// @param field null if it is not wanted.
Computed compute(const Options& options, Communicator& communicator, const Share& share,
  const Grid& grid, const std::vector<Extent>& extents, FieldOutput* field, ProgressBar& bar)
{
  Watch watch(bar);
  MedialAxisOptions wanted = libraryOptions(options, share.bounds.diagonal());
  wanted.field.engine = Engine::Processor;
  wanted.field.execution.progress = &watch;
  const bool alone = reasonForOne(options) != nullptr;
  Computed result;
  RankCounts counts;
  NoField nothing;
  withFailures(options.input,
    [&]
    {
      if (options.wantsAxis() && !alone)
      {
        result.axis = computeMedialAxis(communicator, share.piece, grid, extents,
          field != nullptr ? static_cast<FieldSink&>(*field) : nothing, wanted, &counts);
      }
      else if (field != nullptr)
      {
        computeDistanceField(communicator, share.piece, grid,
          touchingExtent(grid, extents[communicator.rank()]), *field, wanted.field, &counts);
      }
    });
  if (alone)
  {
    result.axis = axisOfOne(communicator, share, grid, wanted);
  }
  result.counts = gatheredValues(communicator, counts);
  result.cells = gatheredValues(communicator, result.axis.axis.cellCount());
  return result;
}

/// Writes an axis, in pieces or gathered, under temporary names.
class RankAxisOutput
{
public:
  explicit RankAxisOutput(const std::filesystem::path& path)
  {
    extensionOf(path) == ".pvtp" ? static_cast<void>(pieces_.emplace(path))
                                 : static_cast<void>(file_.emplace(path));
  }

  void write(Communicator& communicator, const Options& options, const Computed& computed)
  {
    const auto rank = static_cast<std::size_t>(communicator.rank());
    if (pieces_)
    {
      agree(communicator, [&] { pieces_->write(computed.axis, computed.cells, rank); });
      return;
    }
    MedialAxis whole;
    withFailures(options.input, [&] { whole = gatherMedialAxis(communicator, computed.axis); });
    agree(communicator,
      [&]
      {
        if (rank == 0)
        {
          namingFile(file_->path(), [&] { writeWhole(whole, file_->path(), file_->open()); });
        }
      });
  }

  void commitPiece()
  {
    if (pieces_)
    {
      pieces_->commitPiece();
    }
  }

  /// What comes last, on the first rank.
  void commit(int rank)
  {
    if (pieces_)
    {
      pieces_->commitIndex();
    }
    else if (rank == 0)
    {
      file_->commit();
    }
  }

private:
  static void writeWhole(const MedialAxis& axis, const std::filesystem::path& path,
    const std::filesystem::path& file)
  {
    if (const auto format = axisFormatOf(path))
    {
      writeFile(file, [&](std::ostream& stream) { writeAxis(axis, *format, stream); });
      return;
    }
    vtkNew<vtkPolyData> data;
    vtkMeshConversion::ToPolyData(axis, data);
    writeVtp(data, file);
  }

  std::optional<AxisPieces> pieces_;
  std::optional<OutputFile> file_;
};

void printSummary(const Options& options, const Grid& grid, const Computed& computed,
  double seconds)
{
  std::int64_t triangles = 0;
  std::int64_t held = 0;
  for (const RankCounts& count : computed.counts)
  {
    triangles += count.ownTriangles;
    held = std::max(held, count.heldTriangles);
  }
  if (triangles > 0)
  {
    std::printf("mesh      %lld triangles, at most %lld on a process\n",
      static_cast<long long>(triangles), static_cast<long long>(held));
  }
  std::printf("grid      %d x %d x %d, on %zu processes\n", grid.dimensions[0], grid.dimensions[1],
    grid.dimensions[2], computed.counts.size());
  if (options.wantsAxis())
  {
    std::printf("axis      %lld points, %lld cells, at most %lld on a process\n",
      static_cast<long long>(computed.axis.points), static_cast<long long>(computed.axis.cells),
      static_cast<long long>(*std::max_element(computed.cells.begin(), computed.cells.end())));
  }
  std::printf("time      %.2f s\n", seconds);
  for (const auto& [name, path] :
    { std::pair("field", options.field), std::pair("output", options.output) })
  {
    if (!path.empty())
    {
      std::printf("%-9s %s\n", name, path.c_str());
    }
  }
}

void printNotes(const Options& options, const MedialAxis& axis)
{
  printSignNotes(options, axis.statistics.sign, axis.side);
  if (const char* const reason = reasonForOne(options); reason != nullptr && !options.quiet)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: %s looks at the whole axis: the first process computed it alone\n",
      options.input.c_str(), reason);
  }
}

} // namespace

void runOnRanks(const Options& options, Communicator& communicator)
{
  const Timer total;
  checkOptions(options);
  requireSameOptions(options, communicator);
  const int rank = communicator.rank();
  ProgressBar bar(options.quiet || rank > 0);
  std::optional<FieldOutput> field;
  std::optional<RankAxisOutput> axis;
  agree(communicator,
    [&]
    {
      if (!options.field.empty())
      {
        field.emplace(options.field, options.fieldArrays);
      }
      if (options.wantsAxis())
      {
        axis.emplace(options.output);
      }
    });
  bar.show(0.0, "reading");
  const Share share = readShare(options, reasonForOne(options) != nullptr, communicator);
  Grid grid;
  agree(communicator, [&] { grid = gridOf(share.bounds, options); });
  const std::vector<Extent> extents = extentsOf(options, communicator, share, grid, bar);
  agree(communicator,
    [&]
    {
      if (field)
      {
        std::vector<Extent> touching;
        std::transform(extents.begin(), extents.end(), std::back_inserter(touching),
          [&](const Extent& extent) { return touchingExtent(grid, extent); });
        field->begin(grid, touching, static_cast<std::size_t>(rank));
      }
    });
  const Computed computed =
    compute(options, communicator, share, grid, extents, field ? &*field : nullptr, bar);
  if (axis)
  {
    axis->write(communicator, options, computed);
  }
  agree(communicator, [&] { field ? field->finish() : void(); });
  ignoreInterrupts(); // all files are complete; from here on all of them appear
  agree(communicator,
    [&]
    {
      field ? field->commitPieces() : void();
      axis ? axis->commitPiece() : void();
    });
  agree(communicator,
    [&]
    {
      field ? field->commitIndex() : void();
      axis ? axis->commit(rank) : void();
    });
  bar.clear();
  if (rank == 0)
  {
    printNotes(options, computed.axis.axis);
  }
  if (rank == 0 && !options.quiet)
  {
    printSummary(options, grid, computed, total.seconds());
  }
}

} // namespace medial::app
