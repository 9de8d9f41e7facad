#include "ranks/rank_thickness.h"

#include "failure.h"
#include "input/input_file.h"
#include "library_calls.h"
#include "list_message.h"
#include "ranks/rank_agreement.h"
#include "region_table.h"
#include "surface_thickness.h"
#include "thickness_policy.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

/// Divides the surface, if it is to be divided: each rank its piece.
/// @return nothing if the surface stays as it is.
std::optional<SurfacePiece> dividedPiece(Communicator& communicator, const Share& share,
  double maxEdge, const Execution& execution)
{
  if (maxEdge <= 0.0)
  {
    return std::nullopt;
  }
  return subdivide(communicator, share.piece, maxEdge, execution).piece;
}

/// Sends a message to the first rank, and returns there what all have sent, in their order.
std::vector<Message> atFirst(Communicator& communicator, Message own)
{
  std::vector<Message> messages;
  messages.push_back(std::move(own));
  messages.resize(static_cast<std::size_t>(communicator.size()));
  messages = communicator.exchange(std::move(messages));
  return communicator.rank() == 0 ? std::move(messages) : std::vector<Message>{};
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
  std::vector<Message> messages = atFirst(communicator, std::move(own.bytes));
  Thickness whole = thickness;
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

/// Returns the whole surface with the values, on the first rank.
vtkSmartPointer<vtkPolyData> wholeSurface(Share& share, double maxEdge, Thickness thickness,
  const Execution& execution)
{
  Result whole;
  whole.mesh = std::move(share.whole);
  if (maxEdge > 0.0)
  {
    whole.fineMesh = subdivide(whole.mesh, maxEdge, execution);
  }
  whole.thickness = std::move(thickness);
  return withThickness(share.surface.polyData(), whole);
}

/// A triangle beyond a limit.
struct RegionTriangle
{
  int region;
  std::int64_t cell;
  std::array<std::int64_t, 3> points; ///< numbers in the whole surface
  std::array<Point3, 3> corners;
  std::array<float, 3> cornerValues;
  std::array<char, 3> cornerAtEdge;
  float value;
  char atEdge;
};

std::vector<RegionTriangle> trianglesOf(const std::vector<ThicknessRegion>& regions,
  const SurfacePiece& piece, const Thickness& thickness)
{
  std::vector<RegionTriangle> triangles;
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    for (const int triangle : regions[region].triangles)
    {
      RegionTriangle found{};
      found.region = static_cast<int>(region);
      found.cell = piece.mesh.triangleCells[triangle];
      found.value = thickness.triangleValues[triangle];
      found.atEdge = thickness.triangleAtEdge[triangle];
      for (std::size_t i = 0; i < 3; ++i)
      {
        const int corner = piece.mesh.triangles[triangle][i];
        found.points[i] = piece.pointOrder[corner];
        found.corners[i] = piece.mesh.points[corner];
        found.cornerValues[i] = thickness.values[corner];
        found.cornerAtEdge[i] = thickness.atEdge[corner];
      }
      triangles.push_back(found);
    }
  }
  return triangles;
}

/// Makes a mesh of triangles beyond limits, with the regions and values of these.
/// @param weld whether points at the same place are one.
/// @param regions of any piece.
void takeRegions(std::vector<RegionTriangle> triangles, bool weld,
  std::vector<ThicknessRegion> regions, RankThickness& result)
{
  // Pieces of a mesh in several files need not be in the order of cells.
  std::stable_sort(triangles.begin(), triangles.end(),
    [](const RegionTriangle& a, const RegionTriangle& b) { return a.cell < b.cell; });
  for (ThicknessRegion& region : regions)
  {
    region.triangles.clear();
    region.cells.clear();
  }
  TriangleMesh& mesh = result.mesh;
  Thickness& thickness = result.thickness;
  thickness.values.clear();
  thickness.atEdge.clear();
  thickness.triangleValues.clear();
  thickness.triangleAtEdge.clear();
  using Key = std::pair<std::int64_t, Point3>;
  std::map<Key, int> ids;
  for (const RegionTriangle& triangle : triangles)
  {
    std::array<int, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Key key = weld ? Key(0, triangle.corners[i]) : Key(triangle.points[i], Point3{});
      const auto [found, isNew] = ids.insert({ key, static_cast<int>(mesh.points.size()) });
      if (isNew)
      {
        mesh.points.push_back(triangle.corners[i]);
        thickness.values.push_back(triangle.cornerValues[i]);
        thickness.atEdge.push_back(triangle.cornerAtEdge[i]);
      }
      corners[i] = found->second;
    }
    ThicknessRegion& region = regions[triangle.region];
    region.triangles.push_back(static_cast<int>(mesh.triangles.size()));
    if (region.cells.empty() || region.cells.back() != triangle.cell)
    {
      region.cells.push_back(triangle.cell);
    }
    mesh.triangles.push_back(corners);
    mesh.triangleCells.push_back(triangle.cell);
    thickness.triangleValues.push_back(triangle.value);
    thickness.triangleAtEdge.push_back(triangle.atEdge);
  }
  result.regions = std::move(regions);
}

/// Gathers the triangles beyond limits on the first rank, as a mesh with regions and values.
/// @param regions of this rank's piece.
void gatherRegions(Communicator& communicator, const SurfacePiece& piece,
  std::vector<ThicknessRegion> regions, RankThickness& result)
{
  ListMessage own;
  own.put(trianglesOf(regions, piece, result.thickness));
  std::vector<Message> messages = atFirst(communicator, std::move(own.bytes));
  withFailuresOfFirst(communicator,
    [&]
    {
      std::vector<RegionTriangle> triangles;
      for (Message& bytes : messages)
      {
        std::vector<RegionTriangle> some;
        ListMessage(std::move(bytes)).take(some);
        triangles.insert(triangles.end(), some.begin(), some.end());
      }
      takeRegions(std::move(triangles), piece.weld, std::move(regions), result);
    });
}

} // namespace

bool needsWholeForThickness(const Options& options)
{
  return extensionOf(options.thickness) == ".vtp";
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
  const double maxEdge = maxThicknessEdge(options, share.bounds.diagonal());
  std::optional<SurfacePiece> divided;
  std::vector<ThicknessRegion> regions;
  withFailures(options.input,
    [&]
    {
      if (options.hasThicknessLimits() && options.side != Side::Both)
      {
        requireInside(communicator, share.piece, wanted.execution);
      }
      divided = dividedPiece(communicator, share, maxEdge, wanted.execution);
      const SurfacePiece& piece = divided ? *divided : share.piece;
      result.thickness = computeThickness(communicator, piece, wanted, &result.counts);
      if (options.hasThicknessLimits())
      {
        regions = findThicknessRegions(communicator, piece, result.thickness, limits);
      }
    });
  const SurfacePiece& piece = divided ? *divided : share.piece;
  const auto own = static_cast<std::int64_t>(piece.mesh.triangles.size());
  result.triangles = gatheredValues(communicator, own);
  if (extensionOf(options.thickness) == ".pvtp")
  {
    const auto here = result.triangles.begin() + communicator.rank();
    result.piece = pieceWithThickness(piece, result.thickness,
      std::accumulate(result.triangles.begin(), here, std::int64_t{ 0 }));
  }
  if (needsWholeForThickness(options))
  {
    Thickness whole = gatheredThickness(communicator, piece, result.thickness);
    const auto make = [&]
    { result.surface = wholeSurface(share, maxEdge, std::move(whole), wanted.execution); };
    withFailuresOfFirst(communicator, [&] { withFailures(options.input, make); });
  }
  if (options.hasThicknessLimits())
  {
    gatherRegions(communicator, piece, std::move(regions), result);
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
