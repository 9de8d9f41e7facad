#include "ranks/thickness/thickness_part.h"

#include "base/sorted_set.h"
#include "ranks/surface/element_sharing.h"
#include "ranks/surface/point_rings.h"
#include "ranks/surface/surface_part.h"
#include "sign/surface_orientation.h"
#include "thickness/place_values.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace medial
{
namespace
{

/// Returns the corners of elements and the places of rows, points of triangles among them.
std::vector<int> pointsAround(Communicator& communicator, const DistributedSurface& surface,
  const SharedElements& elements, const PlaceRows& rows)
{
  std::vector<int> points;
  for (const SharedElement& element : elements.elements)
  {
    points.insert(points.end(), element.corners.begin(), element.corners.end());
  }
  const auto size = static_cast<int>(kPlacesInRow);
  const auto visit = [&](const std::vector<int>& list, int count, const auto& add)
  {
    for (const int row : list)
    {
      for (int place = size * row; place < std::min(size * (row + 1), count); ++place)
      {
        add(place);
      }
    }
  };
  visit(rows.points, surface.pointCount(), [&](int point) { points.push_back(point); });
  std::vector<int> faces;
  visit(rows.faces, surface.faceCount(), [&](int face) { faces.push_back(face); });
  for (const std::array<int, 3>& corners : answered(
         communicator, faces, [&](int face) { return surface.homeOfFace(face); },
         [&](int face) { return surface.faces()[surface.indexOf(face)].corners; }))
  {
    points.insert(points.end(), corners.begin(), corners.end());
  }
  makeSet(points);
  return points;
}

/// Returns boxes around the blocks of this rank's elements.
std::vector<Box> boxesOf(const SharedElements& elements, const SurfacePart& part,
  const SiteSet& sites)
{
  std::vector<Box> boxes;
  const SharedElement* previous = nullptr;
  for (const SharedElement& element : elements.elements)
  {
    if (previous == nullptr || previous->sizeClass != element.sizeClass ||
      previous->first != element.first)
    {
      boxes.emplace_back();
    }
    const glm::ivec3& corners = sites.faces()[part.faceOf(element.place.site)];
    for (int i = 0; i < 3; ++i)
    {
      boxes.back().add(sites.points()[corners[i]]);
    }
    previous = &element;
  }
  return boxes;
}

} // namespace

void SurfaceAnswer::add(const SurfaceAnswer& other)
{
  if (other.found() &&
    (!this->found() || std::tie(other.distance, other.number) < std::tie(distance, number)))
  {
    *this = other;
  }
}

ThicknessPart::ThicknessPart(Communicator& communicator, const DistributedSurface& surface,
  const ThicknessOptions& options, const Run& run)
  : surface_(surface)
{
  const LocalCoordinates local = LocalCoordinates::around(surface.bounds(), SideThickness::kMargin);
  diagonal_ = surface.bounds().diagonal() / local.unit;
  const SharedElements elements = shareElements(communicator, surface, local);
  rows_ = shareRows(communicator, surface, elements);
  if (!options.cells && options.method != ThicknessMethod::Wall)
  {
    rows_.faces.clear();
  }
  const std::vector<int> points = pointsAround(communicator, surface, elements, rows_);
  const SurfacePart part(communicator, surface, facesAround(communicator, surface, points));
  SurfaceOrientation orientation;
  orientation.directions =
    SharedOrientation(communicator, surface).directionsOf(communicator, part.faces());
  std::optional<OrientedMesh> oriented = turned(part.mesh(), part.connectivity(), orientation);
  if (oriented)
  {
    mesh_ = std::move(oriented->mesh);
    connectivity_ = std::move(oriented->connectivity);
  }
  else
  {
    mesh_ = part.mesh();
    connectivity_ = part.connectivity();
  }
  numbers_ = part.siteNumbers(surface);
  for (std::size_t site = 0; site < numbers_.size(); ++site)
  {
    siteOf_.emplace_back(numbers_[site], static_cast<int>(site));
  }
  std::sort(siteOf_.begin(), siteOf_.end());
  std::vector<int> own;
  for (const SharedElement& element : elements.elements)
  {
    own.push_back(part.faceOf(element.place.site));
  }
  std::vector<char> complete(mesh_.points.size(), 0);
  for (const int point : points)
  {
    if (const int here = this->pointOf(point); here >= 0)
    {
      complete[here] = 1;
    }
  }
  run.onThreads(
    [&]
    {
      query_ =
        std::make_unique<const SurfaceQuery>(local, mesh_, connectivity_, surface.bounds(), own);
      thickness_ = std::make_unique<SideThickness>(*query_, connectivity_, diagonal_, options,
        std::move(complete));
    });
  boxes_ =
    std::make_unique<const SharedBoxes>(communicator, boxesOf(elements, part, query_->sites()));
}

double ThicknessPart::roundedUp(double distance)
{
  constexpr double kRounding = 1e-9;
  return distance * (1.0 + kRounding) + kRounding;
}

std::int32_t ThicknessPart::numberOfPoint(int point) const
{
  return numbers_[query_->sites().firstVertex() + point] - surface_.faceCount() -
    surface_.edgeCount();
}

int ThicknessPart::siteOf(std::int32_t number) const
{
  const auto found = std::lower_bound(siteOf_.begin(), siteOf_.end(), std::pair(number, -1));
  return found != siteOf_.end() && found->first == number ? found->second
                                                          : std::numeric_limits<int>::max();
}

int ThicknessPart::pointOf(int number) const
{
  const int site = this->siteOf(surface_.faceCount() + surface_.edgeCount() + number);
  const auto firstVertex = static_cast<int>(numbers_.size() - mesh_.points.size());
  return site < static_cast<int>(numbers_.size()) ? site - firstVertex : -1;
}

int ThicknessPart::faceOf(int number) const
{
  const int face = this->siteOf(number);
  return face < static_cast<int>(numbers_.size()) ? face : -1;
}

RayStart ThicknessPart::numbered(const RayStart& start) const
{
  return start.point >= 0 ? RayStart{ this->numberOfPoint(start.point), -1 }
                          : RayStart{ -1, numbers_[start.face] };
}

SurfaceAnswer ThicknessPart::answer(const SurfaceQuestion& question) const
{
  OwnSurface own = thickness_->own();
  switch (question.kind)
  {
    case SurfaceQuestion::Kind::Closest:
    {
      const SitePoint found = own.closest(question.x, question.limit);
      return found.site < 0 ? SurfaceAnswer{}
                            : SurfaceAnswer{ glm::distance(found.point, question.x), found.point,
                                numbers_[found.site] };
    }
    case SurfaceQuestion::Kind::Opposite:
    {
      const RayStart& asked = question.start;
      const RayStart start = asked.point >= 0 ? RayStart{ this->pointOf(asked.point), -1 }
                                              : RayStart{ -1, this->faceOf(asked.face) };
      const std::optional<RayEnd> end = thickness_->opposite(
        OppositeSurface::rayFrom(question.x, question.direction, diagonal_), start, question.limit);
      return end ? SurfaceAnswer{ end->distance, end->normal, numbers_[end->face] }
                 : SurfaceAnswer{};
    }
    case SurfaceQuestion::Kind::ConvexEdge:
      return own.nearConvexEdge(question.x, question.limit) ? SurfaceAnswer{ 0.0, {}, 0 }
                                                            : SurfaceAnswer{};
    case SurfaceQuestion::Kind::Seam:
      return own.isSeam(question.x, question.direction) ? SurfaceAnswer{ 0.0, {}, 0 }
                                                        : SurfaceAnswer{};
    default:
      return {};
  }
}

std::vector<int> ThicknessPart::ranksToAsk(const SurfaceQuestion& question,
  const SurfaceAnswer& own) const
{
  switch (question.kind)
  {
    case SurfaceQuestion::Kind::Closest:
    {
      const double reach = roundedUp(own.found() ? own.distance : question.limit);
      return boxes_->ranksWith(
        [&](const Box& box) { return box.squaredDistance(question.x) <= reach * reach; });
    }
    case SurfaceQuestion::Kind::Opposite:
    {
      const HalfLine ray = OppositeSurface::rayFrom(question.x, question.direction, diagonal_);
      return boxes_->ranksWith([&](const Box& box) { return ray.meets(box, question.limit); });
    }
    case SurfaceQuestion::Kind::ConvexEdge:
    case SurfaceQuestion::Kind::Seam:
    {
      const double reach = roundedUp(question.limit);
      return own.found() ? std::vector<int>()
                         : boxes_->ranksWith([&](const Box& box)
                             { return box.squaredDistance(question.x) <= reach * reach; });
    }
    default:
      return {};
  }
}

} // namespace medial
