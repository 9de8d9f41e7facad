#include "axis/contraction.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <numeric>
#include <tuple>

namespace medial
{
namespace
{

using Id = Contraction::Id;

/// Edges shorter than this (voxels) are contracted.
constexpr double kShort = 0.1;
/// The same for edges that end at a moved point.
constexpr double kShortOfMoved = 0.3;
bool isShort(const BisectorPoints& points, Id p, Id q)
{
  const double limit = (points.moved[p] | points.moved[q]) != 0 ? kShortOfMoved : kShort;
  return glm::distance(points.points[p].position, points.points[q].position) < limit;
}

} // namespace

Contraction::Contraction(const BisectorPoints& points)
  : points_(points)
  , sets_(points.points.size())
  , own_(points.points.size())
  , large_(points.points.size(), 0)
  , joined_(points.points.size(), 0)
{
  std::iota(own_.begin(), own_.end(), Id{ 0 });
}

void Contraction::join(Id p, Id q)
{
  p = this->find(p);
  q = this->find(q);
  if (p == q)
  {
    return;
  }
  const bool first = std::tuple(points_.moved[p], p) < std::tuple(points_.moved[q], q);
  sets_.join(p, q);
  own_[sets_.find(p)] = first ? p : q;
  large_[first ? p : q] = 1;
  joined_[p] = 1;
  joined_[q] = 1;
}

void joinEqualPoints(const BisectorPoints& points, std::vector<Id> order, Contraction& contraction)
{
  const auto key = [&](Id p)
  {
    const glm::dvec3& x = points.points[p].position;
    return std::tuple(x.x, x.y, x.z, p);
  };
  std::sort(order.begin(), order.end(), [&](Id p, Id q) { return key(p) < key(q); });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    if (points.points[order[i]].position == points.points[order[i - 1]].position)
    {
      contraction.join(order[i], order[i - 1]);
    }
  }
}

std::vector<std::uint8_t> quadsWithShortEdges(const BisectorPoints& points,
  const std::vector<std::array<Id, 4>>& quads)
{
  std::vector<std::uint8_t> found(quads.size());
  tbb::parallel_for(std::size_t{ 0 }, quads.size(),
    [&](std::size_t i)
    {
      const auto& quad = quads[i];
      for (std::size_t corner = 0; corner < quad.size(); ++corner)
      {
        found[i] |= isShort(points, quad[corner], quad[(corner + 1) % 4]) ? 1 : 0;
      }
    });
  return found;
}

bool joinShortEdges(const BisectorPoints& points, const std::vector<std::array<Id, 4>>& quads,
  const std::vector<std::uint8_t>& withShortEdges, Contraction& contraction)
{
  bool any = false;
  for (std::size_t i = 0; i < quads.size(); ++i)
  {
    const auto& quad = quads[i];
    if (withShortEdges[i] == 0 &&
      std::none_of(quad.begin(), quad.end(),
        [&](Id corner) { return contraction.isJoined(corner); }))
    {
      continue;
    }
    for (std::size_t corner = 0; corner < quad.size(); ++corner)
    {
      const Id p = contraction.find(quad[corner]);
      const Id q = contraction.find(quad[(corner + 1) % 4]);
      if (p != q && isShort(points, p, q))
      {
        contraction.join(p, q);
        any = true;
      }
    }
  }
  return any;
}

} // namespace medial
