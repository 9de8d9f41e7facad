#include "ranks/distributed_surface.h"

#include "base/disjoint_sets.h"
#include "base/id_limits.h"
#include "medial/error.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
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

std::uint64_t hashOf(const Point3& position)
{
  std::uint64_t result = 0;
  for (const double coordinate : position)
  {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &coordinate, sizeof(bits));
    result = (result ^ bits) * 0x9e3779b97f4a7c15u;
    result ^= result >> 32;
  }
  return result;
}

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

Bounds boundsOf(Communicator& communicator, const SurfacePiece& piece)
{
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::array<double, 6> own{ kFar, kFar, kFar, kFar, kFar, kFar }; // the last three negative
  if (!piece.mesh.points.empty())
  {
    const Bounds bounds = piece.mesh.bounds();
    for (int axis = 0; axis < 3; ++axis)
    {
      own[axis] = bounds.min[axis];
      own[3 + axis] = -bounds.max[axis];
    }
  }
  Bounds result{ { kFar, kFar, kFar }, { -kFar, -kFar, -kFar } };
  for (const std::array<double, 6>& values : gathered(communicator, own))
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      result.min[axis] = std::min(result.min[axis], values[axis]);
      result.max[axis] = std::max(result.max[axis], -values[3 + axis]);
    }
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
      throw Error(ErrorCode::InvalidInput,
        "number " + std::to_string(*found) + " of a point or cell is negative");
    }
  }
}

std::int64_t largestOf(const std::vector<std::int64_t>& numbers)
{
  return numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
}

std::string severalCounts(const std::array<std::int64_t, 5>& counts)
{
  std::ostringstream text;
  text << "a surface in pieces must be an oriented manifold of triangles; this one has "
       << counts[0] << " edges of three triangles or more, " << counts[1] << " misoriented edges, "
       << counts[2] << " points where sheets touch, " << counts[3] << " line segments and "
       << counts[4] << " points of no triangle: it needs a single process";
  return text.str();
}

} // namespace

DistributedSurface::DistributedSurface(Communicator& communicator, const SurfacePiece& piece)
{
  agree(communicator, [&] { requirePiece(piece); });
  bounds_ = boundsOf(communicator, piece);
  const std::vector<int> numbers = this->numberPoints(communicator, piece);
  this->collectFaces(communicator, piece, numbers);
  this->connect(communicator, piece, numbers);
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
    asked[i] = static_cast<int>(hashOf(piece.mesh.points[i]) % static_cast<unsigned>(ranks));
    offers[asked[i]].push_back({ piece.mesh.points[i], piece.pointOrder[i] });
  }
  offers = exchanged(communicator, offers);
  const auto order = sortedItems(offers,
    [](const PointOffer& a, const PointOffer& b)
    { return std::tie(a.position, a.order) < std::tie(b.position, b.order); });
  // The first of equal points numbers them.
  RankLists<std::int64_t> firsts = listsFor<std::int64_t>(communicator);
  std::vector<std::pair<int, int>> placeOf; // of each distinct point in `firsts`
  const PointOffer* previous = nullptr;
  RankLists<int> distinct = numbersFor(offers);
  for (const auto& [rank, i] : order)
  {
    const PointOffer& offer = offers[rank][i];
    if (previous == nullptr || previous->position != offer.position)
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
  agree(communicator,
    [&]
    {
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
    });
  RankLists<int> replies = numbersFor(wanted);
  auto number = static_cast<int>(pointOffsets_.first[communicator.rank()]);
  for (const auto& [rank, i] : sorted)
  {
    replies[rank][i] = number++;
  }
  replies = exchanged(communicator, replies);
  for (std::vector<int>& list : distinct)
  {
    for (int& value : list)
    {
      value = replies[placeOf[value].first][placeOf[value].second];
    }
  }
  distinct = exchanged(communicator, distinct);
  std::vector<int> numbers(asked.size());
  std::vector<std::size_t> next(static_cast<std::size_t>(ranks), 0);
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    numbers[i] = distinct[asked[i]][next[asked[i]]++];
  }
  return numbers;
}

void DistributedSurface::collectFaces(Communicator& communicator, const SurfacePiece& piece,
  const std::vector<int>& numbers)
{
  const TriangleMesh& mesh = piece.mesh;
  const Buckets buckets(communicator, largestOf(mesh.triangleCells));
  RankLists<FaceOffer> offers = listsFor<FaceOffer>(communicator);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& [a, b, c] = mesh.triangles[i];
    offers[buckets.of(mesh.triangleCells[i])].push_back(
      { mesh.triangleCells[i], static_cast<std::int64_t>(i), { numbers[a], numbers[b], numbers[c] },
        { mesh.points[a], mesh.points[b], mesh.points[c] } });
  }
  offers = exchanged(communicator, offers);
  const auto order = sortedItems(offers,
    [](const FaceOffer& a, const FaceOffer& b)
    { return std::tie(a.cell, a.part) < std::tie(b.cell, b.part); });
  faceOffsets_ = RankOffsets(communicator, static_cast<std::int64_t>(order.size()));
  agree(communicator,
    [&]
    {
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
    });
  auto face = static_cast<int>(faceOffsets_.first[communicator.rank()]);
  for (const auto& [rank, i] : order)
  {
    const FaceOffer& offer = offers[rank][i];
    faces_.push_back({ offer.cell, face++, offer.corners, { -1, -1, -1 }, offer.points });
  }
}

void DistributedSurface::connect(Communicator& communicator, const SurfacePiece& piece,
  const std::vector<int>& numbers)
{
  RankLists<Side> sides = listsFor<Side>(communicator);
  const auto add = [&](int a, int b, int face, int corner)
  {
    const Side side{ std::min(a, b), std::max(a, b), face, corner, a < b ? 1 : -1 };
    sides[this->pointHome(side.low)].push_back(side);
  };
  for (const FaceRecord& face : faces_)
  {
    for (int i = 0; i < 3; ++i)
    {
      add(face.corners[i], face.corners[(i + 1) % 3], face.face, i);
    }
  }
  // Segments come after all triangles.
  constexpr int kSegment = std::numeric_limits<int>::max();
  for (const auto& [a, b] : piece.mesh.segments)
  {
    add(numbers[a], numbers[b], kSegment, 0);
  }
  RankLists<int> loose = listsFor<int>(communicator);
  for (const int point : piece.mesh.vertices)
  {
    loose[this->pointHome(numbers[point])].push_back(numbers[point]);
  }
  sides = exchanged(communicator, sides);
  loose = exchanged(communicator, loose);
  const auto order = sortedItems(sides,
    [](const Side& a, const Side& b)
    { return std::tie(a.low, a.high, a.face) < std::tie(b.low, b.high, b.face); });
  std::array<std::int64_t, 5> counts{}; // as severalCounts()
  RankLists<std::array<int, 2>> firsts = listsFor<std::array<int, 2>>(communicator);
  RankLists<int> edges = numbersFor(sides);
  std::vector<std::pair<int, int>> placeOf; // of each edge in `firsts`
  for (std::size_t begin = 0; begin < order.size();)
  {
    const Side& first = sides[order[begin].first][order[begin].second];
    std::size_t end = begin;
    int triangles = 0;
    int direction = 0;
    for (; end < order.size(); ++end)
    {
      const Side& side = sides[order[end].first][order[end].second];
      if (!side.joins(first))
      {
        break;
      }
      edges[order[end].first][order[end].second] = static_cast<int>(placeOf.size());
      triangles += side.face != kSegment ? 1 : 0;
      direction += side.face != kSegment ? side.forward : 0;
    }
    counts[0] += triangles > 2 ? 1 : 0;
    counts[1] += triangles == 2 && direction != 0 ? 1 : 0;
    counts[3] += triangles == 0 ? static_cast<std::int64_t>(end - begin) : 0;
    boundaryEdges_ += triangles == 1 ? 1 : 0;
    if (triangles > 0)
    {
      const int home = faceOffsets_.home(first.face);
      placeOf.emplace_back(home, static_cast<int>(firsts[home].size()));
      firsts[home].push_back({ first.face, first.corner });
    }
    else
    {
      placeOf.emplace_back(-1, -1);
    }
    begin = end;
  }
  const RankLists<int> edgeNumbers = this->numberEdges(communicator, firsts);
  for (std::vector<int>& list : edges)
  {
    for (int& edge : list)
    {
      edge = placeOf[edge].first < 0 ? -1 : edgeNumbers[placeOf[edge].first][placeOf[edge].second];
    }
  }
  edges = exchanged(communicator, edges);
  std::vector<std::size_t> next(edges.size(), 0);
  for (FaceRecord& face : faces_)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int home = this->pointHome(std::min(face.corners[i], face.corners[(i + 1) % 3]));
      face.edges[i] = edges[home][next[home]++];
    }
  }
  this->collectRings(communicator);
  std::int64_t points = 0;
  for (const auto& list : loose)
  {
    for (const int point : list)
    {
      const auto found =
        std::lower_bound(ringOfPoint_.begin(), ringOfPoint_.end(), std::pair(point, 0));
      points += found == ringOfPoint_.end() || found->first != point ? 1 : 0;
    }
  }
  counts[4] = points;
  int previous = -1;
  for (const auto& [point, triangle] : ringOfPoint_)
  {
    counts[2] += point != previous && !this->isManifoldPoint(point) ? 1 : 0;
    previous = point;
  }
  std::vector<std::int64_t> sums(counts.begin(), counts.end());
  sums.push_back(boundaryEdges_);
  sums = combined(communicator, sums, std::plus<>());
  boundaryEdges_ = sums.back();
  std::copy_n(sums.begin(), counts.size(), counts.begin());
  if (std::any_of(counts.begin(), counts.end(), [](std::int64_t count) { return count > 0; }))
  {
    throw Error(ErrorCode::InvalidInput, severalCounts(counts));
  }
}

RankLists<int> DistributedSurface::numberEdges(Communicator& communicator,
  const RankLists<std::array<int, 2>>& firstSides)
{
  const RankLists<std::array<int, 2>> asked = exchanged(communicator, firstSides);
  const auto sorted = sortedItems(asked, std::less<>());
  edgeOffsets_ = RankOffsets(communicator, static_cast<std::int64_t>(sorted.size()));
  agree(communicator,
    [&]
    {
      requireCount("the surface",
        edgeOffsets_.total() + faceOffsets_.total() + pointOffsets_.total(), "sites");
    });
  RankLists<int> replies = numbersFor(asked);
  auto number = static_cast<int>(edgeOffsets_.first[communicator.rank()]);
  for (const auto& [rank, i] : sorted)
  {
    replies[rank][i] = number++;
  }
  return exchanged(communicator, replies);
}

void DistributedSurface::collectRings(Communicator& communicator)
{
  RankLists<FaceRecord> records = listsFor<FaceRecord>(communicator);
  for (const FaceRecord& face : faces_)
  {
    std::set<int> homes;
    for (const int corner : face.corners)
    {
      homes.insert(this->pointHome(corner));
    }
    for (const int home : homes)
    {
      records[home].push_back(face);
    }
  }
  for (const std::vector<FaceRecord>& list : exchanged(communicator, records))
  {
    rings_.insert(rings_.end(), list.begin(), list.end());
  }
  for (std::size_t i = 0; i < rings_.size(); ++i)
  {
    for (const int corner : rings_[i].corners)
    {
      if (this->pointHome(corner) == communicator.rank())
      {
        ringOfPoint_.emplace_back(corner, static_cast<int>(i));
      }
    }
  }
  std::sort(ringOfPoint_.begin(), ringOfPoint_.end());
}

bool DistributedSurface::isManifoldPoint(int point) const
{
  const auto begin =
    std::lower_bound(ringOfPoint_.begin(), ringOfPoint_.end(), std::pair(point, 0));
  std::vector<std::pair<int, int>> spokes; // the other ends of edges at the point, and triangles
  int triangles = 0;
  for (auto at = begin; at != ringOfPoint_.end() && at->first == point; ++at, ++triangles)
  {
    for (const int corner : rings_[at->second].corners)
    {
      if (corner != point)
      {
        spokes.emplace_back(corner, triangles);
      }
    }
  }
  std::sort(spokes.begin(), spokes.end());
  // Fans: triangles that share edges. In a closed one there are as many edges as triangles.
  std::vector<int> fan(static_cast<std::size_t>(triangles));
  std::iota(fan.begin(), fan.end(), 0);
  const auto rootOf = [&](int i)
  {
    while (fan[i] != i)
    {
      i = fan[i] = fan[fan[i]];
    }
    return i;
  };
  for (std::size_t i = 1; i < spokes.size(); ++i)
  {
    if (spokes[i].first == spokes[i - 1].first)
    {
      fan[rootOf(spokes[i].second)] = rootOf(spokes[i - 1].second);
    }
  }
  std::vector<int> ends(fan.size(), 0); // edges of one triangle, by fan
  int fans = 0;
  for (int i = 0; i < triangles; ++i)
  {
    fans += rootOf(i) == i ? 1 : 0;
  }
  for (std::size_t i = 0; i < spokes.size(); ++i)
  {
    const bool shared = (i > 0 && spokes[i - 1].first == spokes[i].first) ||
      (i + 1 < spokes.size() && spokes[i + 1].first == spokes[i].first);
    ends[rootOf(spokes[i].second)] += shared ? 0 : 1;
  }
  for (int i = 0; i < triangles; ++i)
  {
    if (rootOf(i) == i && ends[i] == 0 && fans > 1)
    {
      return false;
    }
  }
  return true;
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
  // One rank after the other, since the order of additions decides about the last bits.
  double sum = 0.0;
  for (int rank = 0; rank < communicator.size(); ++rank)
  {
    if (rank == communicator.rank())
    {
      for (const FaceRecord& face : faces_)
      {
        sum += glm::dot(relative(face.points[0]),
          glm::cross(relative(face.points[1]), relative(face.points[2])));
      }
    }
    sum = gathered(communicator, sum)[rank];
  }
  return sum / 6.0;
}

std::vector<FaceRecord> DistributedSurface::around(Communicator& communicator,
  const std::vector<int>& points) const
{
  RankLists<int> asked = listsFor<int>(communicator);
  for (const int point : points)
  {
    asked[this->pointHome(point)].push_back(point);
  }
  asked = exchanged(communicator, asked);
  RankLists<FaceRecord> answers = listsFor<FaceRecord>(communicator);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    std::vector<int> found;
    for (const int point : asked[rank])
    {
      for (auto at =
             std::lower_bound(ringOfPoint_.begin(), ringOfPoint_.end(), std::pair(point, 0));
           at != ringOfPoint_.end() && at->first == point; ++at)
      {
        found.push_back(at->second);
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const int i : found)
    {
      answers[rank].push_back(rings_[i]);
    }
  }
  std::vector<FaceRecord> faces;
  for (const std::vector<FaceRecord>& list : exchanged(communicator, answers))
  {
    faces.insert(faces.end(), list.begin(), list.end());
  }
  return faces;
}

SurfacePiece inRankOrder(Communicator& communicator, TriangleMesh mesh, std::int64_t points,
  std::int64_t cells)
{
  const std::int64_t firstPoint = RankOffsets(communicator, points).first[communicator.rank()];
  const std::int64_t firstCell = RankOffsets(communicator, cells).first[communicator.rank()];
  SurfacePiece piece{ std::move(mesh), {} };
  for (std::vector<std::int64_t>* list :
    { &piece.mesh.triangleCells, &piece.mesh.segmentCells, &piece.mesh.vertexCells })
  {
    for (std::int64_t& cell : *list)
    {
      cell += firstCell;
    }
  }
  piece.pointOrder.assign(piece.mesh.points.size(), -1);
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
