#include "ranks/field/field_part.h"

#include "base/extents.h"
#include "base/huge_pages.h"
#include "field/field_tap.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace medial
{
namespace
{

/// The values at some of the points of an extent.
struct PackedField
{
  std::vector<std::uint8_t> has; ///< a bit for each point
  std::vector<float> distances;
  std::vector<std::int32_t> sites;
};

/// Returns values in the order of an extent that has theirs.
template <typename T>
std::vector<T> movedTo(const Extent& outer, std::vector<T> values, const Extent& inner, T others)
{
  std::vector<T> result = largeVector(static_cast<std::size_t>(outer.pointCount()), others);
  visitWithin(inner, outer, [&](std::size_t i, std::size_t at) { result[i] = values[at]; });
  return result;
}

bool isOn(Side side, float distance)
{
  return side == Side::Both || (distance < 0.0f) == (side == Side::Interior);
}

/// Returns 1 for the points of a part that are on a side or next to a point that is, or 0.
std::vector<std::uint8_t> nearSide(const FieldPart& part, Side side)
{
  std::vector<std::uint8_t> near(part.distances.size());
  std::transform(part.distances.begin(), part.distances.end(), near.begin(),
    [&](float distance) { return isOn(side, distance) ? 1 : 0; });
  const Extent& extent = part.extent;
  std::size_t stride = 1;
  for (int axis = 0; axis < 3 && side != Side::Both; ++axis)
  {
    const std::vector<std::uint8_t> before = near;
    // Blocks of all points with the same coordinates along later axes, in layers across this one.
    const auto length = static_cast<std::size_t>(extent.size(axis));
    for (std::size_t block = 0; block < near.size(); block += stride * length)
    {
      for (std::size_t i = block; i + stride < block + stride * length; ++i)
      {
        near[i] |= before[i + stride];
        near[i + stride] |= before[i];
      }
    }
    stride *= length;
  }
  return near;
}

/// @param extent of the points that go along where wanted() is true of their indices in the part.
template <typename Wanted>
PackedField packed(const FieldPart& part, const Extent& extent, const Wanted& wanted)
{
  PackedField result;
  if (extent.empty())
  {
    return result;
  }
  result.has.resize((static_cast<std::size_t>(extent.pointCount()) + 7) / 8, 0);
  visitWithin(extent, part.extent,
    [&](std::size_t i, std::size_t at)
    {
      if (wanted(i))
      {
        result.has[at / 8] |= static_cast<std::uint8_t>(1u << (at % 8));
        result.distances.push_back(part.distances[i]);
        result.sites.push_back(part.sites[i]);
      }
    });
  return result;
}

/// Sends a list of each kind to each rank.
std::vector<PackedField> exchangedFields(Communicator& communicator,
  std::vector<PackedField> fields)
{
  const auto send = [&](auto list)
  {
    RankLists<typename std::decay_t<decltype(fields.front().*list)>::value_type> lists(
      fields.size());
    for (std::size_t rank = 0; rank < fields.size(); ++rank)
    {
      lists[rank] = std::move(fields[rank].*list);
    }
    lists = exchanged(communicator, std::move(lists));
    for (std::size_t rank = 0; rank < fields.size(); ++rank)
    {
      fields[rank].*list = std::move(lists[rank]);
    }
  };
  send(&PackedField::has);
  send(&PackedField::distances);
  send(&PackedField::sites);
  return fields;
}

/// Calls set(index in the outer extent, index of the value).
template <typename Set>
void unpack(const PackedField& field, const Extent& inner, const Extent& outer, const Set& set)
{
  if (inner.empty())
  {
    return;
  }
  std::size_t value = 0;
  visitWithin(inner, outer,
    [&](std::size_t i, std::size_t at)
    {
      if ((field.has[at / 8] >> (at % 8) & 1) != 0)
      {
        set(i, value++);
      }
    });
}

} // namespace

FieldPart extendedPart(Communicator& communicator, FieldPart own, const std::vector<Extent>& wanted,
  Side side)
{
  const std::vector<Extent> extents = gathered(communicator, own.extent);
  std::vector<PackedField> fields(wanted.size());
  {
    const std::vector<std::uint8_t> near = nearSide(own, side);
    for (std::size_t rank = 0; rank < wanted.size(); ++rank)
    {
      // Of what both have, a rank may not know which points beyond the side are next to it.
      const auto isMissing = [&](std::size_t i)
      {
        return near[i] != 0 &&
          !(isOn(side, own.distances[i]) && hasPoint(extents[rank], pointAt(own.extent, i)));
      };
      if (static_cast<int>(rank) != communicator.rank())
      {
        fields[rank] = packed(own, commonPart(own.extent, wanted[rank]), isMissing);
      }
    }
    std::transform(own.sites.begin(), own.sites.end(), near.begin(), own.sites.begin(),
      [](std::int32_t site, std::uint8_t isNear) { return isNear != 0 ? site : 0; });
  }
  fields = exchangedFields(communicator, std::move(fields));
  const Extent& extent = wanted[communicator.rank()];
  FieldPart part{ extent,
    movedTo(extent, std::move(own.distances), own.extent, unknownDistance(side)), {} };
  part.sites = movedTo(extent, std::move(own.sites), own.extent, 0);
  for (std::size_t rank = 0; rank < fields.size(); ++rank)
  {
    if (static_cast<int>(rank) == communicator.rank())
    {
      continue;
    }
    unpack(fields[rank], commonPart(extents[rank], extent), extent,
      [&](std::size_t i, std::size_t value)
      {
        part.distances[i] = fields[rank].distances[value];
        part.sites[i] = fields[rank].sites[value];
      });
    fields[rank] = {};
  }
  return part;
}

} // namespace medial
