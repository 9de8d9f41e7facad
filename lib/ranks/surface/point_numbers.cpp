#include "ranks/surface/point_numbers.h"

#include "base/id_limits.h"
#include "medial/error.h"
#include "mesh/position_hash.h"
#include "ranks/surface/rank_sorting.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// Stands for the place of a number that points at two positions have.
constexpr int kTwoPositions = -1;

/// A point of a piece.
struct PointOffer
{
  Point3 position;
  std::int64_t order;
};

/// Points that a rank tells apart for all: equal ones are offered to the same.
struct DistinctPoints
{
  RankLists<std::int64_t> firsts;           ///< their lowest numbers, for the ranks that sort these
  std::vector<std::pair<int, int>> placeOf; ///< of each point in `firsts`
  RankLists<int> ofOffer;                   ///< the point, for each offer
};

/// Returns the rank that tells each point of a piece apart from others.
std::vector<int> ranksAsked(const SurfacePiece& piece, int ranks)
{
  std::vector<int> asked(piece.mesh.points.size());
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    const std::uint64_t key =
      piece.weld ? hashOf(piece.mesh.points[i]) : static_cast<std::uint64_t>(piece.pointOrder[i]);
    asked[i] = static_cast<int>(key % static_cast<unsigned>(ranks));
  }
  return asked;
}

DistinctPoints distinctPoints(const RankLists<PointOffer>& offers, bool weld,
  const Buckets& buckets)
{
  const auto order = sortedItems(offers,
    [&](const PointOffer& a, const PointOffer& b)
    {
      return weld ? std::tie(a.position, a.order) < std::tie(b.position, b.order)
                  : std::tie(a.order, a.position) < std::tie(b.order, b.position);
    });
  // The first of equal points numbers them.
  DistinctPoints points;
  points.firsts.resize(offers.size());
  points.ofOffer = numbersFor(offers);
  const PointOffer* previous = nullptr;
  for (const auto& [rank, i] : order)
  {
    const PointOffer& offer = offers[rank][i];
    // The same number at two positions is found by numbersOf().
    const bool isSame = previous != nullptr && previous->position == offer.position &&
      (weld || previous->order == offer.order);
    if (!isSame)
    {
      const int bucket = buckets.of(offer.order);
      points.placeOf.emplace_back(bucket, static_cast<int>(points.firsts[bucket].size()));
      points.firsts[bucket].push_back(offer.order);
    }
    points.ofOffer[rank][i] = static_cast<int>(points.placeOf.size()) - 1;
    previous = &offer;
  }
  return points;
}

/// Returns the places of numbers in the order of all, kTwoPositions for those that are there twice.
RankLists<int> numbersOf(Communicator& communicator, const RankLists<std::int64_t>& firsts,
  RankOffsets& offsets)
{
  const RankLists<std::int64_t> wanted = exchanged(communicator, firsts);
  const auto sorted = sortedItems(wanted, std::less<>());
  offsets = RankOffsets(communicator, static_cast<std::int64_t>(sorted.size()));
  requireCount("the surface", offsets.total(), "points");
  RankLists<int> replies = numbersFor(wanted);
  auto number = static_cast<int>(offsets.first[communicator.rank()]);
  for (const auto& [rank, i] : sorted)
  {
    replies[rank][i] = number++;
  }
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    const auto& [rank, at] = sorted[i];
    const auto& [rankBefore, before] = sorted[i - 1];
    if (wanted[rank][at] == wanted[rankBefore][before])
    {
      replies[rank][at] = kTwoPositions;
      replies[rankBefore][before] = kTwoPositions;
    }
  }
  return exchanged(communicator, std::move(replies));
}

/// Makes replies about distinct points answers to the offers of these.
/// @param points whose `ofOffer` becomes the answers.
void answerOffers(const RankLists<PointOffer>& offers, const RankLists<int>& replies,
  DistinctPoints& points)
{
  for (std::size_t rank = 0; rank < offers.size(); ++rank)
  {
    for (std::size_t i = 0; i < offers[rank].size(); ++i)
    {
      int& answer = points.ofOffer[rank][i];
      const auto& [bucket, at] = points.placeOf[answer];
      // Only the lowest number at a position counts. Who has another one there has made no mistake,
      // and learns from the others that the surface is not numbered.
      const bool counts = offers[rank][i].order == points.firsts[bucket][at];
      answer = counts ? replies[bucket][at] : std::max(replies[bucket][at], 0);
    }
  }
}

} // namespace

std::vector<int> numberPoints(Communicator& communicator, const SurfacePiece& piece,
  RankOffsets& offsets)
{
  const Buckets buckets(communicator, largestOf(piece.pointOrder));
  const std::vector<int> asked = ranksAsked(piece, communicator.size());
  RankLists<PointOffer> offers = listsFor<PointOffer>(communicator);
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    offers[asked[i]].push_back({ piece.mesh.points[i], piece.pointOrder[i] });
  }
  offers = exchanged(communicator, std::move(offers));
  DistinctPoints points = distinctPoints(offers, piece.weld, buckets);
  const RankLists<int> replies = numbersOf(communicator, points.firsts, offsets);
  answerOffers(offers, replies, points);
  const RankLists<int> answers = exchanged(communicator, std::move(points.ofOffer));
  std::vector<int> numbers(asked.size());
  std::vector<std::size_t> next(answers.size(), 0);
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    numbers[i] = answers[asked[i]][next[asked[i]]++];
    if (numbers[i] == kTwoPositions)
    {
      throw Error(ErrorCode::InvalidInput,
        "point " + std::to_string(piece.pointOrder[i]) + " has two positions");
    }
  }
  return numbers;
}

} // namespace medial
