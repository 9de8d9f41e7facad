#include "run_on_ranks.h"

#include "computation.h"
#include "failure.h"
#include "field_output.h"
#include "input_file.h"
#include "interrupt.h"
#include "library_calls.h"
#include "progress_bar.h"
#include "scan_reader.h"
#include "surface_reader.h"
#include "timer.h"

#include "medial/error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

/// Returns what each rank sends to all.
std::vector<Message> gathered(Communicator& communicator, const Message& own)
{
  return communicator.exchange(
    std::vector<Message>(static_cast<std::size_t>(communicator.size()), own));
}

/// Does work that may fail on some ranks only.
/// @throws Failure on every rank if any has failed: that of the first.
void agree(Communicator& communicator, const std::function<void()>& work)
{
  Message failure; // exit code, then message
  try
  {
    withFailures(work);
    throwIfInterrupted();
  }
  catch (const Failure& caught)
  {
    failure.push_back(static_cast<char>(caught.exitCode()));
    const std::string text = caught.what();
    failure.insert(failure.end(), text.begin(), text.end());
  }
  const std::vector<Message> failures = gathered(communicator, failure);
  for (std::size_t rank = 0; rank < failures.size(); ++rank)
  {
    const Message& found = failures[rank];
    if (!found.empty())
    {
      throw Failure(static_cast<ExitCode>(static_cast<unsigned char>(found.front())),
        "rank " + std::to_string(rank) + ": " + std::string(found.begin() + 1, found.end()));
    }
  }
}

/// Several processes compute the field alone.
void checkOptions(const Options& options)
{
  const auto refuse = [](const std::string& message)
  { throw Failure(ExitCode::Usage, "several processes compute the field alone: " + message); };
  if (extensionOf(options.field) != ".pvti")
  {
    refuse("they need --field FILE.pvti");
  }
  const std::pair<const char*, bool> others[] = { { "--local-thickness",
                                                    !options.localThickness.empty() },
    { "thickness", options.wantsThickness() }, { "a medial axis", options.wantsAxis() },
    { "--report", !options.report.empty() }, { "a scan as input", isScanFile(options.input) } };
  for (const auto& [name, wanted] : others)
  {
    if (wanted)
    {
      refuse(std::string(name) + " needs a single one");
    }
  }
  if (options.signMethod != SignMethod::None && options.signMethod != SignMethod::Pseudonormal)
  {
    refuse("they need --sign pseudonormal, for a closed mesh, or --sign none");
  }
  if (options.engine != Engine::Auto && options.engine != Engine::Processor)
  {
    refuse("they need --engine processor");
  }
}

/// What must be the same on every rank.
std::string textOf(const Options& options)
{
  std::string text = options.input.string() + '\n' + options.field.string() + '\n' +
    std::to_string(options.resolution.value_or(0)) + ' ' +
    std::to_string(options.spacing.value_or(0.0)) + ' ' + std::to_string(options.padding) + ' ' +
    std::to_string(static_cast<int>(options.signMethod));
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

/// The lists of a piece, one after the other.
class PieceMessage
{
public:
  template <typename T>
  void put(const std::vector<T>& list)
  {
    const std::uint64_t count = list.size();
    this->append(&count, sizeof(count));
    this->append(list.data(), count * sizeof(T));
  }

  template <typename T>
  void take(std::vector<T>& list)
  {
    std::uint64_t count = 0;
    this->extract(&count, sizeof(count));
    list.resize(count);
    this->extract(list.data(), count * sizeof(T));
  }

  template <typename T>
  void putOne(const T& value)
  {
    this->append(&value, sizeof(value));
  }

  template <typename T>
  void takeOne(T& value)
  {
    this->extract(&value, sizeof(value));
  }

  Message bytes;

private:
  void append(const void* from, std::size_t count)
  {
    const auto* const first = static_cast<const char*>(from);
    bytes.insert(bytes.end(), first, first + count);
  }
  void extract(void* to, std::size_t count)
  {
    if (count > 0)
    {
      std::memcpy(to, bytes.data() + next_, count);
    }
    next_ += count;
  }

  std::size_t next_ = 0;
};

/// What a rank gets of the mesh.
struct Share
{
  SurfacePiece piece;
  Bounds bounds; ///< of the whole
};

/// Takes triangles [begin, end) out of a mesh.
SurfacePiece pieceOf(const TriangleMesh& mesh, std::size_t begin, std::size_t end)
{
  SurfacePiece piece;
  std::map<int, int> localOf;
  const auto local = [&](int point)
  {
    const auto [found, isNew] =
      localOf.insert({ point, static_cast<int>(piece.mesh.points.size()) });
    if (isNew)
    {
      piece.mesh.points.push_back(mesh.points[point]);
      piece.pointOrder.push_back(point);
    }
    return found->second;
  };
  for (std::size_t i = begin; i < end; ++i)
  {
    std::array<int, 3> corners{};
    std::transform(mesh.triangles[i].begin(), mesh.triangles[i].end(), corners.begin(), local);
    piece.mesh.triangles.push_back(corners);
    piece.mesh.triangleCells.push_back(mesh.triangleCells[i]);
  }
  if (begin == 0)
  {
    for (const auto& [a, b] : mesh.segments)
    {
      const int first = local(a);
      piece.mesh.segments.push_back({ first, local(b) });
    }
    std::transform(mesh.vertices.begin(), mesh.vertices.end(),
      std::back_inserter(piece.mesh.vertices), local);
    piece.mesh.segmentCells = mesh.segmentCells;
    piece.mesh.vertexCells = mesh.vertexCells;
  }
  return piece;
}

/// Cuts a mesh into messages for all ranks.
std::vector<Message> sharesOf(const TriangleMesh& mesh, std::size_t ranks)
{
  const std::size_t triangles = mesh.triangles.size();
  if (!std::is_sorted(mesh.triangleCells.begin(), mesh.triangleCells.end()))
  {
    throw Failure(ExitCode::BadInput, "its triangles are not in the order of cells");
  }
  const Bounds bounds = mesh.bounds();
  std::vector<Message> messages;
  std::size_t begin = 0;
  for (std::size_t rank = 1; rank <= ranks; ++rank)
  {
    std::size_t end = std::max(begin, triangles * rank / ranks);
    // The triangles of a cell stay together.
    while (end > begin && end < triangles && mesh.triangleCells[end] == mesh.triangleCells[end - 1])
    {
      ++end;
    }
    const SurfacePiece piece = pieceOf(mesh, begin, end);
    PieceMessage message;
    message.putOne(bounds);
    message.put(piece.mesh.points);
    message.put(piece.pointOrder);
    message.put(piece.mesh.triangles);
    message.put(piece.mesh.triangleCells);
    message.put(piece.mesh.segments);
    message.put(piece.mesh.segmentCells);
    message.put(piece.mesh.vertices);
    message.put(piece.mesh.vertexCells);
    messages.push_back(std::move(message.bytes));
    begin = end;
  }
  return messages;
}

/// The first rank reads the mesh, and hands it out.
Share readShare(const Options& options, Communicator& communicator)
{
  std::vector<Message> messages(static_cast<std::size_t>(communicator.size()));
  agree(communicator,
    [&]
    {
      if (communicator.rank() == 0)
      {
        withFailures(options.input,
          [&]
          { messages = sharesOf(readSurface(options.input).toTriangleMesh(), messages.size()); });
      }
    });
  PieceMessage message;
  message.bytes = std::move(communicator.exchange(std::move(messages)).front());
  Share share;
  message.takeOne(share.bounds);
  message.take(share.piece.mesh.points);
  message.take(share.piece.pointOrder);
  message.take(share.piece.mesh.triangles);
  message.take(share.piece.mesh.triangleCells);
  message.take(share.piece.mesh.segments);
  message.take(share.piece.mesh.segmentCells);
  message.take(share.piece.mesh.vertices);
  message.take(share.piece.mesh.vertexCells);
  return share;
}

/// Parts of a grid, neighbours sharing a layer of points, as VTK's images of pieces do.
std::vector<Extent> touchingParts(const Grid& grid, int parts)
{
  std::vector<Extent> extents = partsOfGrid(grid, parts);
  for (Extent& extent : extents)
  {
    for (int axis = 0; axis < 3 && !extent.empty(); ++axis)
    {
      extent.max[axis] = std::min(extent.max[axis] + 1, grid.dimensions[axis] - 1);
    }
  }
  return extents;
}

void printSummary(const Options& options, const Grid& grid, const std::vector<RankCounts>& counts,
  double seconds)
{
  std::int64_t triangles = 0;
  std::int64_t held = 0;
  for (const RankCounts& count : counts)
  {
    triangles += count.ownTriangles;
    held = std::max(held, count.heldTriangles);
  }
  std::printf("mesh      %lld triangles, at most %lld on a process\n"
              "grid      %d x %d x %d, on %zu processes\n"
              "time      %.2f s\n"
              "field     %s\n",
    static_cast<long long>(triangles), static_cast<long long>(held), grid.dimensions[0],
    grid.dimensions[1], grid.dimensions[2], counts.size(), seconds, options.field.c_str());
}

std::vector<RankCounts> gatheredCounts(Communicator& communicator, const RankCounts& own)
{
  Message message(sizeof(own));
  std::memcpy(message.data(), &own, sizeof(own));
  std::vector<RankCounts> counts;
  for (const Message& received : gathered(communicator, message))
  {
    counts.emplace_back();
    std::memcpy(&counts.back(), received.data(), sizeof(own));
  }
  return counts;
}

} // namespace

void runOnRanks(const Options& options, Communicator& communicator)
{
  const Timer total;
  checkOptions(options);
  requireSameOptions(options, communicator);
  const auto rank = static_cast<std::size_t>(communicator.rank());
  ProgressBar bar(options.quiet || rank > 0);
  std::optional<FieldOutput> field;
  agree(communicator, [&] { field.emplace(options.field, options.fieldArrays); });
  bar.show(0.0, "reading");
  const Share share = readShare(options, communicator);
  Grid grid;
  std::vector<Extent> extents;
  agree(communicator,
    [&]
    {
      grid = gridOf(share.bounds, options);
      extents = touchingParts(grid, communicator.size());
      field->begin(grid, extents, rank);
    });
  Watch watch(bar);
  DistanceFieldOptions wanted = libraryOptions(options, share.bounds.diagonal()).field;
  wanted.execution.progress = &watch;
  RankCounts counts;
  // It fails on every rank alike.
  withFailures(options.input,
    [&] {
      computeDistanceField(communicator, share.piece, grid, extents[rank], *field, wanted, &counts);
    });
  agree(communicator, [&] { field->finish(); });
  agree(communicator, [&] { field->commitPieces(); });
  agree(communicator, [&] { field->commitIndex(); });
  const std::vector<RankCounts> all = gatheredCounts(communicator, counts);
  bar.clear();
  if (rank == 0 && !options.quiet)
  {
    printSummary(options, grid, all, total.seconds());
  }
}

} // namespace medial::app
