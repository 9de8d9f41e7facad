#include "ranks/surface/distributed_surface.h"

#include "base/counted.h"
#include "base/id_limits.h"
#include "base/range_check.h"
#include "medial/error.h"
#include "mesh/position_hash.h"
#include "ranks/surface/point_rings.h"

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

/// A point of a piece.
struct PointOffer
{
  Point3 position;
  std::int64_t order;
};

/// A triangle of a piece.
struct FaceOffer
{
  std::int64_t cell;
  std::int64_t part; ///< number of the triangle in its piece
  std::array<int, 3> corners;
  std::array<Point3, 3> points;
};

/// Shares numbers out evenly, if they are.
class Buckets
{
public:
  /// @param largest of this rank; -1 for none.
  Buckets(Communicator& communicator, std::int64_t largest)
    : size_(maximum(communicator, largest) / communicator.size() + 1)
  {
  }

  int of(std::int64_t number) const { return static_cast<int>(number / size_); }

private:
  std::int64_t size_;
};

/// The indices of the items of lists, one list after the other, sorted.
template <typename Item, typename Less>
std::vector<std::pair<int, int>> sortedItems(const RankLists<Item>& lists, const Less& less)
{
  std::vector<std::pair<int, int>> order;
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (std::size_t i = 0; i < lists[rank].size(); ++i)
    {
      order.emplace_back(static_cast<int>(rank), static_cast<int>(i));
    }
  }
  std::sort(order.begin(), order.end(),
    [&](const auto& a, const auto& b)
    {
      const Item& x = lists[a.first][a.second];
      const Item& y = lists[b.first][b.second];
      return less(x, y) || (!less(y, x) && a < b);
    });
  return order;
}

/// Returns lists of numbers as long as others.
template <typename Item>
RankLists<int> numbersFor(const RankLists<Item>& lists)
{
  RankLists<int> numbers(lists.size());
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    numbers[rank].resize(lists[rank].size());
  }
  return numbers;
}

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

std::int64_t largestOf(const std::vector<std::int64_t>& numbers)
{
  return numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
}

} // namespace

DistributedSurface::DistributedSurface(Communicator& communicator, const SurfacePiece& piece)
{
  requirePiece(piece);
  bounds_ = boundsOfAll(communicator, piece);
  pointsOfPiece_ = this->numberPoints(communicator, piece);
  this->collectFaces(communicator, piece);
  this->connect(communicator);
  this->requireNothingLoose(communicator, piece);
  signedVolume_ = this->sumVolume(communicator);
}

std::vector<int> DistributedSurface::numberPoints(Communicator& communicator,
  const SurfacePiece& piece)
{
  const int ranks = communicator.size();
  const Buckets buckets(communicator, largestOf(piece.pointOrder));
  RankLists<PointOffer> offers = listsFor<PointOffer>(communicator);
  std::vector<int> asked(piece.mesh.points.size());
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    const std::uint64_t key =
      piece.weld ? hashOf(piece.mesh.points[i]) : static_cast<std::uint64_t>(piece.pointOrder[i]);
    asked[i] = static_cast<int>(key % static_cast<unsigned>(ranks));
    offers[asked[i]].push_back({ piece.mesh.points[i], piece.pointOrder[i] });
  }
  offers = exchanged(communicator, std::move(offers));
  const auto order = sortedItems(offers,
    [&](const PointOffer& a, const PointOffer& b)
    {
      return piece.weld ? std::tie(a.position, a.order) < std::tie(b.position, b.order)
                        : std::tie(a.order, a.position) < std::tie(b.order, b.position);
    });
  // The first of equal points numbers them.
  RankLists<std::int64_t> firsts = listsFor<std::int64_t>(communicator);
  std::vector<std::pair<int, int>> placeOf; // of each distinct point in `firsts`
  const PointOffer* previous = nullptr;
  RankLists<int> distinct = numbersFor(offers);
  for (const auto& [rank, i] : order)
  {
    const PointOffer& offer = offers[rank][i];
    // The same number at two positions is found below.
    const bool isSame = previous != nullptr && previous->position == offer.position &&
      (piece.weld || previous->order == offer.order);
    if (!isSame)
    {
      const int bucket = buckets.of(offer.order);
      placeOf.emplace_back(bucket, static_cast<int>(firsts[bucket].size()));
      firsts[bucket].push_back(offer.order);
    }
    distinct[rank][i] = static_cast<int>(placeOf.size()) - 1;
    previous = &offer;
  }
  const RankLists<std::int64_t> wanted = exchanged(communicator, firsts);
  const auto sorted = sortedItems(wanted, std::less<>());
  pointOffsets_ = RankOffsets(communicator, static_cast<std::int64_t>(sorted.size()));
  requireCount("the surface", pointOffsets_.total(), "points");
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    const auto& [rank, at] = sorted[i];
    if (wanted[rank][at] == wanted[sorted[i - 1].first][sorted[i - 1].second])
    {
      throw Error(ErrorCode::InvalidInput,
        "point " + std::to_string(wanted[rank][at]) + " has two positions");
    }
  }
  RankLists<int> replies = numbersFor(wanted);
  auto number = static_cast<int>(pointOffsets_.first[communicator.rank()]);
  for (const auto& [rank, i] : sorted)
  {
    replies[rank][i] = number++;
  }
  replies = exchanged(communicator, std::move(replies));
  for (std::vector<int>& list : distinct)
  {
    for (int& value : list)
    {
      value = replies[placeOf[value].first][placeOf[value].second];
    }
  }
  distinct = exchanged(communicator, std::move(distinct));
  std::vector<int> numbers(asked.size());
  std::vector<std::size_t> next(static_cast<std::size_t>(ranks), 0);
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    numbers[i] = distinct[asked[i]][next[asked[i]]++];
  }
  return numbers;
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
