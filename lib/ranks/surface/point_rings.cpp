#include "ranks/surface/point_rings.h"

#include "base/sorted_set.h"
#include "medial/triangle_mesh.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace medial
{
namespace
{

bool isFlat(const FaceRecord& face)
{
  return !hasArea(face.points[0], face.points[1], face.points[2]);
}

} // namespace

PointRings::PointRings(Communicator& communicator, const DistributedSurface& surface)
  : surface_(surface)
{
  RankLists<Corner> lists = listsFor<Corner>(communicator);
  for (const FaceRecord& face : surface.faces())
  {
    for (const int point : face.corners)
    {
      lists[surface.homeOfPoint(point)].push_back({ point, { face.face, isFlat(face) ? 1 : 0 } });
    }
  }
  corners_ = flattened(exchanged(communicator, std::move(lists)));
  std::sort(corners_.begin(), corners_.end(),
    [](const Corner& a, const Corner& b)
    { return std::tie(a.point, a.at.face) < std::tie(b.point, b.at.face); });
}

std::vector<RingFace> PointRings::around(Communicator& communicator,
  const std::vector<int>& points) const
{
  const auto arrange = [](std::vector<RingFace>& list)
  {
    std::sort(list.begin(), list.end(),
      [](const RingFace& a, const RingFace& b) { return a.face < b.face; });
    list.erase(std::unique(list.begin(), list.end(),
                 [](const RingFace& a, const RingFace& b) { return a.face == b.face; }),
      list.end());
  };
  RankLists<int> asked = listsFor<int>(communicator);
  for (const int point : points)
  {
    asked[surface_.homeOfPoint(point)].push_back(point);
  }
  asked = exchanged(communicator, std::move(asked));
  RankLists<RingFace> answers = listsFor<RingFace>(communicator);
  for (std::size_t rank = 0; rank < asked.size(); ++rank)
  {
    for (const int point : asked[rank])
    {
      auto at = std::lower_bound(corners_.begin(), corners_.end(), point,
        [](const Corner& corner, int wanted) { return corner.point < wanted; });
      for (; at != corners_.end() && at->point == point; ++at)
      {
        answers[rank].push_back(at->at);
      }
    }
    arrange(answers[rank]);
  }
  std::vector<RingFace> found = flattened(exchanged(communicator, std::move(answers)));
  arrange(found);
  return found;
}

std::vector<int> facesAround(Communicator& communicator, const DistributedSurface& surface,
  std::vector<int> points)
{
  const PointRings rings(communicator, surface);
  std::vector<int> faces;
  std::vector<int> known; // points, ascending
  makeSet(points);
  for (int row = 0; row <= kMaxFlatRow; ++row)
  {
    std::vector<int> flat;
    for (const RingFace& found : rings.around(communicator, points))
    {
      faces.push_back(found.face);
      if (found.isFlat != 0)
      {
        flat.push_back(found.face);
      }
    }
    if (maximum(communicator, flat.size()) == 0)
    {
      break;
    }
    std::vector<int> all;
    std::set_union(known.begin(), known.end(), points.begin(), points.end(),
      std::back_inserter(all));
    known = std::move(all);
    std::vector<int> corners;
    for (const FaceRecord& face : surface.fetch(communicator, flat))
    {
      corners.insert(corners.end(), face.corners.begin(), face.corners.end());
    }
    makeSet(corners);
    points.clear();
    std::set_difference(corners.begin(), corners.end(), known.begin(), known.end(),
      std::back_inserter(points));
  }
  makeSet(faces);
  return faces;
}

} // namespace medial
