#include "ranks/thickness/place_rows.h"

#include "thickness/place_values.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace medial
{
namespace
{

/// How many corners or elements of a row a rank has.
struct Vote
{
  int row;
  int rank;
  int count;
};

int rowOf(int place)
{
  return place / static_cast<int>(kPlacesInRow);
}

/// Returns the rows that this rank gets, of those that ranks have voted for.
/// @param places how many there are on all ranks.
std::vector<int> sharedOut(Communicator& communicator, const std::map<int, int>& counts, int places)
{
  const int ranks = communicator.size();
  std::vector<Vote> votes;
  for (const auto& [row, count] : counts)
  {
    votes.push_back({ row, communicator.rank(), count });
  }
  const int rows = rowOf(places - 1) + 1;
  votes =
    delivered(communicator, votes, [&](const Vote& vote) { return homeOf(vote.row, rows, ranks); });
  std::map<int, Vote> winners;
  // Of equal counts another rank wins in each row, so that all get their share.
  const auto order = [ranks](const Vote& vote)
  { return std::tuple(-vote.count, (vote.rank + vote.row) % ranks); };
  for (const Vote& vote : votes)
  {
    const auto [found, isFirst] = winners.insert({ vote.row, vote });
    if (!isFirst && order(vote) < order(found->second))
    {
      found->second = vote;
    }
  }
  votes.clear();
  std::transform(winners.begin(), winners.end(), std::back_inserter(votes),
    [](const auto& winner) { return winner.second; });
  std::vector<int> own;
  for (const Vote& vote : delivered(communicator, votes, [](const Vote& won) { return won.rank; }))
  {
    own.push_back(vote.row);
  }
  std::sort(own.begin(), own.end());
  return own;
}

} // namespace

PlaceRows shareRows(Communicator& communicator, const DistributedSurface& surface,
  const SharedElements& elements)
{
  std::map<int, int> points;
  std::map<int, int> faces;
  for (const SharedElement& element : elements.elements)
  {
    ++faces[rowOf(element.place.site)];
    for (const int corner : element.corners)
    {
      ++points[rowOf(corner)];
    }
  }
  return { sharedOut(communicator, points, surface.pointCount()),
    sharedOut(communicator, faces, surface.faceCount()) };
}

} // namespace medial
