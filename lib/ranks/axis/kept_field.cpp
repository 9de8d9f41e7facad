#include "ranks/axis/kept_field.h"

#include "base/extents.h"
#include "ranks/axis/sites_here.h"
#include "ranks/collective.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace medial
{
namespace
{

/// Some of 64 points in a row, as CornerNumbers has them.
struct PointsOfRow
{
  std::int64_t block;   ///< number of the first over 64
  std::uint64_t points; ///< a bit for each
};

constexpr std::int64_t kRow = 64;

/// Returns the sites with some numbers; the first one for those that are not here, of points that
/// the side does not need.
std::vector<std::int32_t> sitesHere(const SitesHere& sites,
  const std::vector<std::int32_t>& numbers)
{
  std::vector<std::int32_t> result(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    // Most neighbours have the same.
    result[i] =
      i > 0 && numbers[i] == numbers[i - 1] ? result[i - 1] : std::max(0, sites.find(numbers[i]));
  }
  return result;
}

} // namespace

KeptField::KeptField(Communicator& communicator, const RankPart& part, const Grid& grid,
  FieldPart values, Side side)
  : communicator_(communicator)
  , part_(part)
  , numbers_(grid)
  , extent_(part.share().withHalo(1))
  , sites_(blocksFor(static_cast<std::size_t>(extent_.pointCount())))
{
  std::vector<std::int32_t> colours;
  if (part_.field().hasSign() && side != Side::Exterior)
  {
    bodies_.emplace(communicator_, part_.field());
    colours = this->findBodies(values);
  }
  const Extent inner = values.extent;
  std::vector<Extent> wanted;
  for (int rank = 0; rank < communicator_.size(); ++rank)
  {
    wanted.push_back(part_.share().withHalo(rank, 1));
  }
  this->keep(extendedPart(communicator_, std::move(values), wanted, side));
  if (bodies_ && bodies_->colours() > 1)
  {
    this->setColours(inner, colours);
  }
}

/// @param values in the part and a layer around.
void KeptField::keep(FieldPart values)
{
  distances_ = std::move(values.distances);
  for (std::size_t point = 0; point < values.sites.size(); ++point)
  {
    if (values.sites[point] != 0)
    {
      sites_.make(point / kBlockLength)[point % kBlockLength] = values.sites[point];
    }
  }
}

/// @return the colours of the points inside, if there are several.
std::vector<std::int32_t> KeptField::findBodies(const FieldPart& values)
{
  if (bodies_->parts() < 2)
  {
    return {};
  }
  const DepthField depth(values.distances.data(), Side::Interior, part_.field().frame().unit);
  std::vector<std::int32_t> colours =
    sitesHere(SitesHere(part_.field().siteNumbers()), values.sites);
  bodies_->findColours(communicator_, values.extent, numbers_.size(), colours.data(), depth);
  const std::vector<int> siteColours = this->siteColours();
  if (siteColours.empty())
  {
    return {};
  }
  for (std::size_t point = 0; point < colours.size(); ++point)
  {
    colours[point] = depth.wanted(point) ? siteColours[colours[point]] : 0;
  }
  return colours;
}

/// Sets the colours of all points. Those that others have computed may have sites that are not
/// here.
/// @param colours in the inner extent.
void KeptField::setColours(const Extent& inner, const std::vector<std::int32_t>& colours)
{
  allColours_.resize(static_cast<std::size_t>(bodies_->colours()));
  std::iota(allColours_.begin(), allColours_.end(), 0);
  pointColours_.resize(distances_.size());
  visitWithin(inner, extent_,
    [&](std::size_t i, std::size_t at) { pointColours_[i] = colours[at]; });
  const DepthField depth(distances_.data(), Side::Interior, part_.field().frame().unit);
  std::vector<std::int64_t> elsewhere;
  visitWithin(extent_, part_.share().whole(),
    [&](std::size_t number, std::size_t point)
    {
      if (depth.wanted(point) && !hasPoint(inner, numbers_.position(number)))
      {
        elsewhere.push_back(static_cast<std::int64_t>(number));
      }
    });
  const std::vector<std::int32_t> found = answered(
    communicator_, elsewhere,
    [&](std::int64_t number) { return part_.share().ownerOf(numbers_.position(number)); },
    [&](std::int64_t number) { return colours[pointIndex(inner, numbers_.position(number))]; });
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    pointColours_[pointIndex(extent_, numbers_.position(elsewhere[i]))] = found[i];
  }
}

DepthField KeptField::depth(Side side, int colour) const
{
  DepthField depth(distances_.data(), side, part_.field().frame().unit);
  if (this->colours(side) > 1)
  {
    depth.restrict(pointColours_.data(), allColours_.data(), colour);
  }
  return depth;
}

std::vector<int> KeptField::siteColours() const
{
  return bodies_ && bodies_->colours() > 1 ? bodies_->siteColours(communicator_)
                                           : std::vector<int>();
}

/// Returns the values at points of a row that are in this rank's part.
std::vector<FieldValue> KeptField::valuesIn(std::int64_t block, std::uint64_t points) const
{
  std::vector<FieldValue> values;
  for (; points != 0; points &= points - 1)
  {
    const std::size_t point = pointIndex(extent_,
      numbers_.position(kRow * block + static_cast<std::int64_t>(__builtin_ctzll(points))));
    values.push_back({ distances_[point], sites_[point / kBlockLength][point % kBlockLength] });
  }
  return values;
}

std::vector<FieldValue> KeptField::at(const std::vector<std::int64_t>& points) const
{
  RankLists<PointsOfRow> lists = listsFor<PointsOfRow>(communicator_);
  std::vector<int> homes;
  for (const std::int64_t number : points)
  {
    const glm::ivec3 point = numbers_.position(number);
    const bool same = !homes.empty() && hasPoint(part_.share().of(homes.back()), point);
    homes.push_back(same ? homes.back() : part_.share().ownerOf(point));
    std::vector<PointsOfRow>& list = lists[homes.back()];
    if (list.empty() || list.back().block != number / kRow)
    {
      list.push_back({ number / kRow, 0 });
    }
    list.back().points |= std::uint64_t{ 1 } << (number % kRow);
  }
  lists = exchanged(communicator_, std::move(lists));
  RankLists<FieldValue> answers = listsFor<FieldValue>(communicator_);
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    for (const PointsOfRow& row : lists[rank])
    {
      const std::vector<FieldValue> values = this->valuesIn(row.block, row.points);
      answers[rank].insert(answers[rank].end(), values.begin(), values.end());
    }
  }
  answers = exchanged(communicator_, std::move(answers));
  std::vector<FieldValue> values;
  std::vector<std::size_t> next(answers.size(), 0);
  for (const int home : homes)
  {
    values.push_back(answers[home][next[home]++]);
  }
  return values;
}

} // namespace medial
