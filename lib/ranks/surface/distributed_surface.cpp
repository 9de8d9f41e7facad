#include "ranks/surface/distributed_surface.h"

#include "base/counted.h"
#include "base/id_limits.h"
#include "base/range_check.h"
#include "medial/error.h"
#include "ranks/surface/point_numbers.h"
#include "ranks/surface/point_rings.h"
#include "ranks/surface/rank_sorting.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <tuple>

namespace medial
{
namespace
{

/// A triangle of a piece.
struct FaceOffer
{
  std::int64_t cell;
  std::int64_t part; ///< number of the triangle in its piece
  std::array<int, 3> corners;
  std::array<Point3, 3> points;
};

Bounds boundsOfAll(Communicator& communicator, const SurfacePiece& piece)
{
  Bounds result = kEmptyBounds;
  for (const Bounds& bounds : gathered(communicator, boundsOf(piece.mesh.points)))
  {
    result = joined(result, bounds);
  }
  return result;
}

void requirePiece(const SurfacePiece& piece)
{
  const TriangleMesh& mesh = piece.mesh;
  if (piece.pointOrder.size() != mesh.points.size() ||
    mesh.triangleCells.size() != mesh.triangles.size())
  {
    throw Error(ErrorCode::InvalidInput, "the piece's lists of numbers differ in size from it");
  }
  const auto negative = [](std::int64_t number) { return number < 0; };
  for (const std::vector<std::int64_t>* list : { &piece.pointOrder, &mesh.triangleCells })
  {
    const auto found = std::find_if(list->begin(), list->end(), negative);
    if (found != list->end())
    {
      throwOutside("number of a point or cell", *found, "[0, infinity)");
    }
  }
}

} // namespace

DistributedSurface::DistributedSurface(Communicator& communicator, const SurfacePiece& piece)
{
  requirePiece(piece);
  bounds_ = boundsOfAll(communicator, piece);
  pointsOfPiece_ = numberPoints(communicator, piece, pointOffsets_);
  this->collectFaces(communicator, piece);
  this->connect(communicator);
  this->requireNothingLoose(communicator, piece);
  signedVolume_ = this->sumVolume(communicator);
}

void DistributedSurface::collectFaces(Communicator& communicator, const SurfacePiece& piece)
{
  const TriangleMesh& mesh = piece.mesh;
  const std::vector<int>& numbers = pointsOfPiece_;
  const Buckets buckets(communicator, largestOf(mesh.triangleCells));
  RankLists<FaceOffer> offers = listsFor<FaceOffer>(communicator);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& [a, b, c] = mesh.triangles[i];
    offers[buckets.of(mesh.triangleCells[i])].push_back(
      { mesh.triangleCells[i], static_cast<std::int64_t>(i), { numbers[a], numbers[b], numbers[c] },
        { mesh.points[a], mesh.points[b], mesh.points[c] } });
  }
  offers = exchanged(communicator, std::move(offers));
  const auto order = sortedItems(offers,
    [](const FaceOffer& a, const FaceOffer& b)
    { return std::tie(a.cell, a.part) < std::tie(b.cell, b.part); });
  faceOffsets_ = RankOffsets(communicator, static_cast<std::int64_t>(order.size()));
  if (faceOffsets_.total() == 0)
  {
    throw Error(ErrorCode::InvalidInput, "the mesh has no triangles");
  }
  requireCount("the surface", faceOffsets_.total(), "triangles", kMaxCorners / 3);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    const FaceOffer& face = offers[order[i].first][order[i].second];
    const FaceOffer& before = offers[order[i - 1].first][order[i - 1].second];
    if (face.cell == before.cell && order[i].first != order[i - 1].first)
    {
      throw Error(ErrorCode::InvalidInput,
        "the pieces overlap: cell " + std::to_string(face.cell) + " is in those of ranks " +
          std::to_string(order[i - 1].first) + " and " + std::to_string(order[i].first));
    }
  }
  faces_.reserve(order.size());
  origins_.reserve(order.size());
  auto face = static_cast<int>(faceOffsets_.first[communicator.rank()]);
  for (const auto& [rank, i] : order)
  {
    const FaceOffer& offer = offers[rank][i];
    faces_.push_back({ offer.cell, face++, offer.corners, { -1, -1, -1 }, offer.points });
    origins_.push_back({ rank, static_cast<int>(offer.part) });
  }
}

void DistributedSurface::connect(Communicator& communicator)
{
  RankLists<Side> lists = listsFor<Side>(communicator);
  for (const FaceRecord& face : faces_)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = face.corners[i];
      const int b = face.corners[(i + 1) % 3];
      lists[this->homeOfPoint(std::min(a, b))].push_back(
        { std::min(a, b), std::max(a, b), face.face, i, a < b ? 1 : -1 });
    }
  }
  const RankLists<Side> received = exchanged(communicator, std::move(lists));
  const auto order = sortedItems(received,
    [](const Side& a, const Side& b)
    { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  std::vector<Side> sides;
  std::vector<std::array<int, 2>> firsts; // sides of edges
  RankLists<int> edges = numbersFor(received);
  for (const auto& [rank, i] : order)
  {
    const Side& side = received[rank][i];
    if (sides.empty() || !side.joins(sides.back()))
    {
      firsts.push_back({ side.face, side.corner });
    }
    sides.push_back(side);
    edges[rank][i] = static_cast<int>(firsts.size()) - 1;
  }
  const std::vector<int> numbers = this->numberEdges(communicator, firsts);
  for (std::vector<int>& list : edges)
  {
    std::transform(list.begin(), list.end(), list.begin(), [&](int edge) { return numbers[edge]; });
  }
  edges = exchanged(communicator, std::move(edges));
  std::vector<std::size_t> next(edges.size(), 0);
  for (FaceRecord& face : faces_)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int home = this->homeOfPoint(std::min(face.corners[i], face.corners[(i + 1) % 3]));
      face.edges[i] = edges[home][next[home]++];
    }
  }
  this->countEdges(communicator, sides);
}

/// @param sides of this rank's edges, one edge after the other.
void DistributedSurface::countEdges(Communicator& communicator, const std::vector<Side>& sides)
{
  std::vector<std::int64_t> counts(3, 0);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    int direction = 0;
    for (; end < sides.size() && sides[end].joins(sides[begin]); ++end)
    {
      direction += sides[end].forward;
    }
    counts[0] += end - begin == 1 ? 1 : 0;
    counts[1] += end - begin > 2 ? 1 : 0;
    counts[2] += end - begin == 2 && direction != 0 ? 1 : 0;
  }
  counts = combined(communicator, counts, std::plus<>());
  edgeCounts_ = { counts[0], counts[1], counts[2] };
}

void DistributedSurface::requireNothingLoose(Communicator& communicator,
  const SurfacePiece& piece) const
{
  std::vector<int> points;
  std::transform(piece.mesh.vertices.begin(), piece.mesh.vertices.end(), std::back_inserter(points),
    [&](int point) { return pointsOfPiece_[point]; });
  std::vector<std::array<int, 2>> segments;
  for (const auto& [a, b] : piece.mesh.segments)
  {
    segments.push_back({ std::min(pointsOfPiece_[a], pointsOfPiece_[b]),
      std::max(pointsOfPiece_[a], pointsOfPiece_[b]) });
  }
  if (maximum(communicator, points.size() + segments.size()) == 0)
  {
    return;
  }
  const std::size_t vertices = points.size();
  std::transform(segments.begin(), segments.end(), std::back_inserter(points),
    [](const std::array<int, 2>& ends) { return ends[0]; });
  std::set<int> corners;
  std::set<std::array<int, 2>> sides;
  std::vector<int> faces;
  for (const RingFace& found : PointRings(communicator, *this).around(communicator, points))
  {
    faces.push_back(found.face);
  }
  for (const FaceRecord& face : this->fetch(communicator, faces))
  {
    for (int i = 0; i < 3; ++i)
    {
      const int a = face.corners[i];
      const int b = face.corners[(i + 1) % 3];
      corners.insert(a);
      sides.insert({ std::min(a, b), std::max(a, b) });
    }
  }
  std::vector<std::int64_t> counts{ std::count_if(segments.begin(), segments.end(),
                                      [&](const std::array<int, 2>& ends)
                                      { return sides.count(ends) == 0; }),
    std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(vertices),
      [&](int point) { return corners.count(point) == 0; }) };
  counts = combined(communicator, counts, std::plus<>());
  if (counts[0] + counts[1] > 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "a surface in pieces must consist of triangles; this one has " +
        counted(counts[0], "line segment") + " and " + counted(counts[1], "point") +
        " of no triangle: it needs a single process");
  }
}

std::vector<int> DistributedSurface::numberEdges(Communicator& communicator,
  const std::vector<std::array<int, 2>>& firstSides)
{
  RankLists<std::array<int, 2>> asked = listsFor<std::array<int, 2>>(communicator);
  std::vector<int> homes;
  for (const std::array<int, 2>& side : firstSides)
  {
    homes.push_back(faceOffsets_.home(side[0]));
    asked[homes.back()].push_back(side);
  }
  asked = exchanged(communicator, std::move(asked));
  const auto sorted = sortedItems(asked, std::less<>());
  edgeOffsets_ = RankOffsets(communicator, static_cast<std::int64_t>(sorted.size()));
  requireCount("the surface", edgeOffsets_.total() + faceOffsets_.total() + pointOffsets_.total(),
    "sites");
  RankLists<int> replies = numbersFor(asked);
  auto number = static_cast<int>(edgeOffsets_.first[communicator.rank()]);
  for (const auto& [rank, i] : sorted)
  {
    replies[rank][i] = number++;
  }
  replies = exchanged(communicator, std::move(replies));
  std::vector<int> numbers;
  std::vector<std::size_t> next(replies.size(), 0);
  for (const int home : homes)
  {
    numbers.push_back(replies[home][next[home]++]);
  }
  return numbers;
}

double DistributedSurface::sumVolume(Communicator& communicator) const
{
  const auto relative = [&](const Point3& p)
  {
    glm::dvec3 result;
    for (int axis = 0; axis < 3; ++axis)
    {
      result[axis] = p[axis] - (0.5 * bounds_.min[axis] + 0.5 * bounds_.max[axis]);
    }
    return result;
  };
  return inTurn(communicator, 0.0,
           [&](double& sum)
           {
             for (const FaceRecord& face : faces_)
             {
               sum += glm::dot(relative(face.points[0]),
                 glm::cross(relative(face.points[1]), relative(face.points[2])));
             }
           }) /
    6.0;
}

std::vector<FaceRecord> DistributedSurface::fetch(Communicator& communicator,
  const std::vector<int>& faces) const
{
  RankLists<int> asked = listsFor<int>(communicator);
  for (const int face : faces)
  {
    asked[this->homeOfFace(face)].push_back(face);
  }
  asked = exchanged(communicator, std::move(asked));
  RankLists<FaceRecord> records = listsFor<FaceRecord>(communicator);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    records[rank].reserve(asked[rank].size());
    std::transform(asked[rank].begin(), asked[rank].end(), std::back_inserter(records[rank]),
      [&](int face) { return faces_[this->indexOf(face)]; });
  }
  return flattened(exchanged(communicator, std::move(records)));
}

std::vector<std::array<int, 3>> DistributedSurface::edgesOfPiece(Communicator& communicator,
  std::size_t triangles) const
{
  struct Sent
  {
    Origin to;
    std::array<int, 3> edges;
  };
  std::vector<Sent> sent;
  sent.reserve(faces_.size());
  for (std::size_t i = 0; i < faces_.size(); ++i)
  {
    sent.push_back({ origins_[i], faces_[i].edges });
  }
  std::vector<std::array<int, 3>> edges(triangles);
  for (const Sent& received :
    delivered(communicator, sent, [](const Sent& item) { return item.to.rank; }))
  {
    edges[received.to.triangle] = received.edges;
  }
  return edges;
}

void DistributedSurface::dropFaces()
{
  std::vector<FaceRecord>().swap(faces_);
  std::vector<Origin>().swap(origins_);
}

SurfacePiece inRankOrder(Communicator& communicator, TriangleMesh mesh, std::int64_t points,
  std::int64_t cells)
{
  std::int64_t firstPoint = 0;
  std::int64_t firstCell = 0;
  SurfacePiece piece{ std::move(mesh), {} };
  agree(communicator,
    [&]
    {
      firstPoint = RankOffsets(communicator, points).first[communicator.rank()];
      firstCell = RankOffsets(communicator, cells).first[communicator.rank()];
      piece.pointOrder.assign(piece.mesh.points.size(), -1);
    });
  for (std::vector<std::int64_t>* list :
    { &piece.mesh.triangleCells, &piece.mesh.segmentCells, &piece.mesh.vertexCells })
  {
    for (std::int64_t& cell : *list)
    {
      cell += firstCell;
    }
  }
  for (std::size_t i = 0; i < piece.mesh.pointOfInput.size(); ++i)
  {
    const int point = piece.mesh.pointOfInput[i];
    if (point >= 0 && piece.pointOrder[point] < 0)
    {
      piece.pointOrder[point] = firstPoint + static_cast<std::int64_t>(i);
    }
  }
  return piece;
}

} // namespace medial
