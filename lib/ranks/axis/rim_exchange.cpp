#include "ranks/axis/rim_exchange.h"

#include <algorithm>
#include <limits>
#include <set>

namespace medial
{
namespace
{

/// Returns the own vertices of rims, ascending, and lets the others wait for their owners.
std::vector<std::int32_t> ownOf(const GridShare& share, const RimExchange::Vertices& vertices,
  BorderRims& rims)
{
  std::vector<std::int32_t> own;
  for (std::size_t i = 0; i < rims.size(); ++i)
  {
    if (share.owns(vertices.cellOf(rims.vertex(i))))
    {
      own.push_back(static_cast<std::int32_t>(i));
    }
    else
    {
      rims.hold(i);
    }
  }
  return own;
}

} // namespace

RimExchange::RimExchange(Communicator& communicator, const GridShare& share,
  const Vertices& vertices, BorderRims* rims)
  : communicator_(communicator)
  , rims_(rims)
  , wanted_(listsFor<std::int32_t>(communicator))
  , sent_(listsFor<std::int32_t>(communicator))
{
  std::vector<std::int32_t> own;
  if (rims_ != nullptr)
  {
    own = ownOf(share, vertices, *rims_);
    std::set<std::int32_t> others;
    for (const std::int32_t i : own)
    {
      for (const int neighbour : rims_->neighbours(static_cast<std::size_t>(i)))
      {
        if (neighbour >= 0 && !std::binary_search(own.begin(), own.end(), neighbour))
        {
          others.insert(neighbour);
        }
      }
    }
    for (const std::int32_t i : others)
    {
      wanted_[share.ownerOf(vertices.cellOf(rims_->vertex(i)))].push_back(i);
    }
  }
  const auto numberOf = [&](std::int32_t i) { return vertices.numberOf(rims_->vertex(i)); };
  RankLists<std::int64_t> numbers = listsFor<std::int64_t>(communicator);
  for (std::size_t rank = 0; rank < wanted_.size(); ++rank)
  {
    std::transform(wanted_[rank].begin(), wanted_[rank].end(), std::back_inserter(numbers[rank]),
      numberOf);
  }
  numbers = exchanged(communicator_, std::move(numbers));
  for (std::size_t rank = 0; rank < sent_.size(); ++rank)
  {
    for (const std::int64_t number : numbers[rank])
    {
      const auto at = std::lower_bound(own.begin(), own.end(), number,
        [&](std::int32_t i, std::int64_t value) { return numberOf(i) < value; });
      sent_[rank].push_back(at != own.end() && numberOf(*at) == number ? *at : -1);
    }
  }
  const RankLists<glm::dvec3> places = this->received();
  for (std::size_t rank = 0; rank < wanted_.size(); ++rank)
  {
    for (std::size_t k = 0; k < wanted_[rank].size(); ++k)
    {
      alike_ = alike_ && rims_->place(wanted_[rank][k]) == places[rank][k];
    }
  }
}

RankLists<glm::dvec3> RimExchange::received()
{
  RankLists<glm::dvec3> places(sent_.size());
  for (std::size_t rank = 0; rank < sent_.size(); ++rank)
  {
    for (const std::int32_t i : sent_[rank])
    {
      places[rank].push_back(
        i >= 0 ? rims_->place(i) : glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    }
  }
  return exchanged(communicator_, places);
}

void RimExchange::update()
{
  const RankLists<glm::dvec3> places = this->received();
  for (std::size_t rank = 0; rank < wanted_.size(); ++rank)
  {
    for (std::size_t k = 0; k < wanted_[rank].size(); ++k)
    {
      rims_->setPlace(wanted_[rank][k], places[rank][k]);
    }
  }
}

} // namespace medial
