#include "ranks/rank_thickness.h"

#include "failure.h"
#include "input/input_file.h"
#include "library_calls.h"
#include "list_message.h"
#include "ranks/rank_agreement.h"
#include "region_table.h"
#include "surface_thickness.h"

#include "medial/mesh_connectivity.h"

#include <algorithm>
#include <string>
#include <utility>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

/// Checks what limits need, and divides the surface, if it is to be divided: each rank its piece,
/// and the first one the whole, too, where it has it.
/// @return the divided piece; nothing if the surface stays as it is.
std::optional<SurfacePiece> dividedPiece(const Options& options, Communicator& communicator,
  const Share& share, const ThicknessOptions& wanted, RankThickness& result)
{
  withSharedFailures(communicator,
    [&]
    {
      if (communicator.rank() == 0 && options.hasThicknessLimits() && options.side != Side::Both)
      {
        withFailures(options.input,
          [&]
          {
            requireInside(result.mesh, analyseConnectivity(result.mesh, wanted.execution),
              wanted.execution);
          });
      }
    });
  const double maxEdge = maxThicknessEdge(options, share.bounds.diagonal());
  if (maxEdge <= 0.0)
  {
    return std::nullopt;
  }
  SurfacePiece piece;
  withFailures(options.input,
    [&] { piece = subdivide(communicator, share.piece, maxEdge, wanted.execution).piece; });
  withSharedFailures(communicator,
    [&]
    {
      if (communicator.rank() == 0 && needsWholeForThickness(options))
      {
        withFailures(options.input,
          [&] { result.fineMesh = subdivide(result.mesh, maxEdge, wanted.execution); });
      }
    });
  return piece;
}

/// Returns the values of the whole surface, on the first rank. Its triangles lie on the ranks one
/// after the other.
Thickness gatheredThickness(Communicator& communicator, const SurfacePiece& piece,
  const Thickness& thickness)
{
  ListMessage own;
  own.put(piece.pointOrder);
  own.put(thickness.values);
  own.put(thickness.atEdge);
  own.put(thickness.triangleValues);
  own.put(thickness.triangleAtEdge);
  std::vector<Message> messages;
  messages.push_back(std::move(own.bytes)); // for the first rank
  messages.resize(static_cast<std::size_t>(communicator.size()));
  Thickness whole = thickness;
  messages = communicator.exchange(std::move(messages));
  if (communicator.rank() > 0)
  {
    return whole;
  }
  whole.values.assign(static_cast<std::size_t>(thickness.points), 0.0F);
  whole.atEdge.assign(whole.values.size(), 0);
  whole.triangleValues.clear();
  whole.triangleAtEdge.clear();
  for (Message& bytes : messages)
  {
    ListMessage message(std::move(bytes));
    std::vector<std::int64_t> points;
    std::vector<float> values;
    std::vector<char> atEdge;
    message.take(points);
    message.take(values);
    message.take(atEdge);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      whole.values[points[i]] = values[i];
      whole.atEdge[points[i]] = atEdge[i];
    }
    message.take(values);
    message.take(atEdge);
    whole.triangleValues.insert(whole.triangleValues.end(), values.begin(), values.end());
    whole.triangleAtEdge.insert(whole.triangleAtEdge.end(), atEdge.begin(), atEdge.end());
  }
  return whole;
}

/// Finds regions and attaches values to the surface, on the first rank.
void finishWhole(const Options& options, Share& share, const ThicknessLimits& limits,
  Thickness thickness, RankThickness& result)
{
  Result whole;
  whole.mesh = std::move(result.mesh);
  whole.fineMesh = std::move(result.fineMesh);
  whole.thickness = std::move(thickness);
  if (options.hasThicknessLimits())
  {
    result.regions = findThicknessRegions(whole.thicknessMesh(), *whole.thickness, limits);
  }
  if (extensionOf(options.thickness) == ".vtp")
  {
    result.surface = withThickness(share.surface.polyData(), whole);
  }
  result.mesh = std::move(whole.mesh);
  result.fineMesh = std::move(whole.fineMesh);
  result.thickness = std::move(*whole.thickness);
}

} // namespace

bool needsWholeForThickness(const Options& options)
{
  return options.hasThicknessLimits() || extensionOf(options.thickness) == ".vtp";
}

RankThickness computeThickness(const Options& options, Communicator& communicator, Share& share,
  ProgressBar& bar)
{
  RankThickness result;
  const ThicknessLimits limits = thicknessLimits(options, share.bounds.diagonal());
  if (options.hasThicknessLimits())
  {
    requireLimits(limits);
  }
  Watch watch(bar);
  ThicknessOptions wanted = thicknessOptions(options);
  wanted.execution.progress = &watch;
  result.mesh = std::move(share.whole);
  const std::optional<SurfacePiece> divided =
    dividedPiece(options, communicator, share, wanted, result);
  const SurfacePiece& piece = divided ? *divided : share.piece;
  withFailures(options.input,
    [&] { result.thickness = computeThickness(communicator, piece, wanted, &result.counts); });
  const auto own = static_cast<std::int64_t>(piece.mesh.triangles.size());
  result.triangles = gatheredValues(communicator, own);
  if (extensionOf(options.thickness) == ".pvtp")
  {
    std::int64_t first = 0;
    for (int rank = 0; rank < communicator.rank(); ++rank)
    {
      first += result.triangles[rank];
    }
    result.piece = pieceWithThickness(piece, result.thickness, first);
  }
  if (options.hasThicknessLimits() || extensionOf(options.thickness) == ".vtp")
  {
    Thickness whole = gatheredThickness(communicator, piece, result.thickness);
    withSharedFailures(communicator,
      [&]
      {
        if (communicator.rank() == 0)
        {
          withFailures(options.input,
            [&] { finishWhole(options, share, limits, std::move(whole), result); });
        }
      });
  }
  return result;
}

void requireNoRegions(const Options& options, Communicator& communicator, const Result& result)
{
  std::string text;
  if (communicator.rank() == 0)
  {
    try
    {
      requireNoRegions(options, result);
    }
    catch (const Failure& failure)
    {
      text = failure.what();
    }
  }
  const Message message = gathered(communicator, Message(text.begin(), text.end())).front();
  if (!message.empty())
  {
    throw Failure(ExitCode::BeyondLimits, std::string(message.begin(), message.end()));
  }
}

} // namespace medial::app
