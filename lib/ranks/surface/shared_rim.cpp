#include "ranks/surface/shared_rim.h"

#include "ranks/collective.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// How a triangle's side counts at an edge.
struct CountedSide
{
  int patch;
  int edge;
  int face;
  int corner;  ///< where it starts
  int forward; ///< how often it runs from the lower point to the higher
};

/// Where a triangle's side lies.
struct SidePlace
{
  std::array<int, 2> ends; ///< the lower point first
  std::array<Point3, 2> points;
};

/// Adds up the sides of each edge and patch, and returns those that do not cancel out, ascending.
std::vector<CountedSide> netsOf(std::vector<CountedSide> sides)
{
  std::sort(sides.begin(), sides.end(),
    [](const CountedSide& a, const CountedSide& b)
    { return std::tie(a.edge, a.patch, a.face) < std::tie(b.edge, b.patch, b.face); });
  std::vector<CountedSide> nets;
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    CountedSide net = sides[begin];
    for (end = begin + 1;
         end < sides.size() && sides[end].edge == net.edge && sides[end].patch == net.patch; ++end)
    {
      net.forward += sides[end].forward;
    }
    if (net.forward != 0)
    {
      nets.push_back(net);
    }
  }
  return nets;
}

SidePlace placeOf(const FaceRecord& face, int corner)
{
  int low = corner;
  int high = (corner + 1) % 3;
  if (face.corners[low] > face.corners[high])
  {
    std::swap(low, high);
  }
  return { { face.corners[low], face.corners[high] }, { face.points[low], face.points[high] } };
}

} // namespace

std::vector<SharedRimEdge> sharedRim(Communicator& communicator, const DistributedSurface& surface,
  const std::vector<CountedFace>& faces)
{
  std::vector<CountedSide> own;
  for (const CountedFace& counted : faces)
  {
    const FaceRecord& face = surface.faces()[counted.index];
    for (int corner = 0; corner < 3; ++corner)
    {
      const bool forward = face.corners[corner] < face.corners[(corner + 1) % 3];
      own.push_back({ counted.patch, face.edges[corner], face.face, corner,
        forward ? counted.weight : -counted.weight });
    }
  }
  const std::vector<CountedSide> nets = netsOf(delivered(communicator, own,
    [&](const CountedSide& side)
    { return homeOf(side.edge, surface.edgeCount(), communicator.size()); }));
  const std::vector<SidePlace> places = answered(
    communicator, nets, [&](const CountedSide& side) { return surface.homeOfFace(side.face); },
    [&](const CountedSide& side)
    { return placeOf(surface.faces()[surface.indexOf(side.face)], side.corner); });
  std::vector<SharedRimEdge> rim;
  for (std::size_t i = 0; i < nets.size(); ++i)
  {
    auto [ends, points] = places[i];
    if (nets[i].forward < 0)
    {
      std::swap(ends[0], ends[1]);
      std::swap(points[0], points[1]);
    }
    rim.push_back(
      { nets[i].patch, nets[i].edge, { ends[0], ends[1], std::abs(nets[i].forward) }, points });
  }
  return rim;
}

} // namespace medial
