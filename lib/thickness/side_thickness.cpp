#include "thickness/side_thickness.h"

#include "thickness/place_values.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace medial
{
namespace
{

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// First position on a ray: this share of the size of the cells that meet at its start.
constexpr double kFirstShare = 0.05;
/// Next position on a ray, in multiples of the thickness at the previous place.
constexpr double kGuess = 1.0;
/// Surfaces that bend by less, degrees, count as one tessellated surface: what is seen from a ball
/// under a smaller angle to the start may be nearer than the start.
constexpr double kMaxBend = kDefaultAngle;
/// What is seen under a larger angle may be nearer by this share only.
constexpr double kTouching = 0.95;
/// The same for walls, whose values do not suffer from it: a bar that is as wide as thick touches a
/// ball between opposite sides in the very middle of a side only.
constexpr double kTouchingWall = 0.8;
/// Radius of a ball as a share of the way of its centre, up to which the ray runs in another face,
/// such as the next one at a seam.
constexpr double kInFace = 1e-6;
/// Where the side opens by more, degrees, another part of the solid begins. Facets of rounded
/// surfaces turn less.
constexpr double kOpens = 30.0;
/// Rays of an edge start this share of the way from it to the middle of each of its faces.
constexpr double kFromEdge = 1e-6;

/// Returns the features at some points.
SharpFeatures ofPoints(const SiteSet& sites, const SharpFeatures& sharp,
  const std::vector<char>& wanted)
{
  SharpFeatures result;
  for (std::size_t point = 0; point < wanted.size(); ++point)
  {
    result.points.push_back(sharp.points[point] != 0 && wanted[point] != 0 ? 1 : 0);
  }
  std::copy_if(sharp.edges.begin(), sharp.edges.end(), std::back_inserter(result.edges),
    [&](int edge)
    { return wanted[sites.edges()[edge][0]] != 0 || wanted[sites.edges()[edge][1]] != 0; });
  return result;
}

} // namespace

SideThickness::SideThickness(const SurfaceQuery& surface, const MeshConnectivity& connectivity,
  double diagonal, const ThicknessOptions& options, std::vector<char> complete)
  : surface_(surface)
  , connectivity_(connectivity)
  , method_(options.method)
  , angle_(options.ballAngle())
  , tellsEdges_(options.cells)
  , diagonal_(diagonal)
  , complete_(std::move(complete))
  , sites_(surface_.sites())
{
  if (method_ == ThicknessMethod::Ray || angle_ > kMaxBend)
  {
    opposite_.emplace(sites_, diagonal_);
  }
}

void SideThickness::face(Side side)
{
  sign_ = side == Side::Exterior ? -1.0 : 1.0;
  inward_.clear();
  for (int vertex = 0; vertex < sites_.vertexCount(); ++vertex)
  {
    const glm::dvec3 normal = surface_.normal(sites_.firstVertex() + vertex);
    const double length = glm::length(normal);
    inward_.push_back(length > 0.0 ? -sign_ * normal / length : glm::dvec3(0.0));
  }
  const bool ray = method_ == ThicknessMethod::Ray;
  const double bend = ray ? kMaxBend : std::min(angle_, kMaxBend);
  const SharpFeatures bends = sharpFeatures(sites_, connectivity_, inward_, sign_, bend);
  bent_ = bends.points;
  sharp_ = ray || angle_ <= kMaxBend
    ? bent_
    : sharpFeatures(sites_, connectivity_, inward_, sign_, angle_).points;
  if (method_ == ThicknessMethod::Wall)
  {
    this->findOpenEdges();
    borders_.emplace(sites_, connectivity_, diagonal_, sign_, complete_);
  }
  if (tellsEdges_)
  {
    edges_.emplace(sites_, complete_.empty() ? bends : ofPoints(sites_, bends, complete_));
  }
}

void SideThickness::findOpenEdges()
{
  // What opens is convex, seen from the other side.
  std::vector<glm::dvec3> outward;
  std::transform(inward_.begin(), inward_.end(), std::back_inserter(outward), std::negate<>());
  const SharpFeatures open = sharpFeatures(sites_, connectivity_, outward, -sign_, kOpens);
  opens_ = open.points;
  opensAlong_.assign(static_cast<std::size_t>(sites_.faceCount()), 0);
  for (const int edge : open.edges)
  {
    const auto& ends = sites_.edges()[edge];
    const IncidenceLists& faces = connectivity_.edgeTriangles;
    for (const int* face = faces.begin(edge); face != faces.end(edge); ++face)
    {
      opensAlong_[*face] |= bitOfEdge(sites_.faces()[*face], ends);
    }
  }
}

SideThickness::Value SideThickness::atPoint(int point, double guess, SurfaceAnswers& surface) const
{
  Value value = this->valueAtPoint(point, guess, surface);
  value.opens = opens_.empty() ? 0 : opens_[point];
  return value;
}

SideThickness::Value SideThickness::atTriangle(int triangle, double guess,
  SurfaceAnswers& surface) const
{
  Value value = this->valueAtTriangle(triangle, guess, surface);
  value.opens = opensAlong_.empty() ? 0 : opensAlong_[triangle];
  return value;
}

SideThickness::Value SideThickness::valueAtPoint(int point, double guess,
  SurfaceAnswers& surface) const
{
  if (inward_[point] == glm::dvec3(0.0))
  {
    return { kNone };
  }
  const TouchingBall::Ray ray{ sites_.points()[point], inward_[point] };
  const RayStart start{ point, -1 };
  if (method_ == ThicknessMethod::Ray)
  {
    return sharp_[point] ? this->rayAtEdge(point, surface) : this->rayAt(ray, start, surface);
  }
  if (sharp_[point])
  {
    return { 0.0, true };
  }
  if (method_ == ThicknessMethod::Wall && bent_[point])
  {
    return { kNone }; // the walls are those of the faces beside it
  }
  return this->ballAt({ ray, start, kFirstShare * this->shortestEdge(point), guess }, surface);
}

SideThickness::Value SideThickness::valueAtTriangle(int triangle, double guess,
  SurfaceAnswers& surface) const
{
  const glm::dvec3 inward = this->inwardOfFace(triangle);
  if (inward == glm::dvec3(0.0))
  {
    return { kNone };
  }
  const TouchingBall::Ray ray{ this->centreOf(triangle), inward };
  const RayStart start{ -1, triangle };
  if (method_ == ThicknessMethod::Ray)
  {
    return this->rayAt(ray, start, surface);
  }
  return this->ballAt({ ray, start, kFirstShare * this->lowestThirdOfHeight(triangle), guess },
    surface);
}

SideThickness::Value SideThickness::ballAt(const Place& place, SurfaceAnswers& surface) const
{
  const TouchingBall::Ray& ray = place.ray;
  const std::optional<TouchingBall::Ball> ball = this->touchingBall(place, surface);
  if (!ball)
  {
    return { kNone };
  }
  const glm::dvec3 centre = ray.start + ball->position * ray.direction;
  const bool atEdge = tellsEdges_ &&
    (ball->radius == 0.0 ||
      isExplainedByEdge(ray.start, -ray.direction, ball->opposite,
        (ball->opposite - centre) / ball->radius, surface));
  // The way to the wall through the ball's centre: its diameter, if the ball touches the start.
  const double thickness =
    method_ == ThicknessMethod::Wall ? ball->position + ball->radius : 2.0 * ball->radius;
  return { thickness * surface_.local().unit, atEdge };
}

/// A ball on the other side of the surface opposite does not touch the start, nor does one that is
/// not far enough from a wall to touch the start, and sees this wall under less than the angle,
/// does not count. Neighbouring facets are no such wall.
std::optional<TouchingBall::Ball> SideThickness::touchingBall(const Place& place,
  SurfaceAnswers& surface) const
{
  const auto& [ray, start, first, guess] = place;
  const auto touches = [this, &from = start](int site) { return this->meets(site, from); };
  const TouchingBall ball(surface, angle_, diagonal_);
  const double position = guess > 0.0 ? kGuess * guess / surface_.local().unit : ball.reach();
  if (angle_ <= kMaxBend)
  {
    return ball.find(ray, first, position, touches);
  }
  const TouchingBall bends(surface, kMaxBend, diagonal_);
  const std::optional<TouchingBall::Ball> bent = this->beyondSeams(bends, ray,
    bends.find(ray, first, position, touches), bends.reach(), surface);
  if (!bent)
  {
    return std::nullopt;
  }
  const double touching = method_ == ThicknessMethod::Wall ? kTouchingWall : kTouching;
  if (bent->position > 0.0)
  {
    TouchingBall::Ray close = ray;
    close.minCloseness = touching * std::min(bent->startCloseness, bent->closeness);
    const auto exit =
      surface.opposite(OppositeSurface::rayFrom(ray.start, ray.direction, diagonal_), start);
    const double end = exit ? exit->distance : ball.reach();
    return end > bent->position
      ? this->beyondSeams(ball, close, ball.findBehind(close, *bent, end), end, surface)
      : std::nullopt;
  }
  const std::optional<TouchingBall::Ball> found = ball.find(ray, first, position, touches);
  return found && found->closeness >= touching * found->startCloseness ? found : std::nullopt;
}

/// Where a surface is not welded, the border of the next face may be right beside a place, as if
/// there were a wall as thin as the gap. What touches the ball there is passed over.
std::optional<TouchingBall::Ball> SideThickness::beyondSeams(const TouchingBall& balls,
  const TouchingBall::Ray& ray, std::optional<TouchingBall::Ball> ball, double end,
  SurfaceAnswers& surface) const
{
  if (method_ != ThicknessMethod::Wall)
  {
    return ball;
  }
  const auto touchesSeam = [&]
  {
    const glm::dvec3 way = ray.start + ball->position * ray.direction - ball->opposite;
    return ball->position < balls.minStart() || ball->radius <= kInFace * ball->position ||
      surface.isSeam(ball->opposite, way / glm::length(way));
  };
  while (ball && ball->position > 0.0 && touchesSeam())
  {
    ball = balls.findBeyond(ray, *ball, end);
  }
  return ball;
}

SideThickness::Value SideThickness::rayAt(const TouchingBall::Ray& ray, const RayStart& start,
  SurfaceAnswers& surface) const
{
  const std::optional<RayEnd> end =
    surface.opposite(OppositeSurface::rayFrom(ray.start, ray.direction, diagonal_), start);
  if (!end)
  {
    return { kNone };
  }
  const bool atEdge = tellsEdges_ &&
    isExplainedByEdge(ray.start, -ray.direction, ray.start + end->distance * ray.direction,
      sign_ * end->normal, surface);
  return { end->distance * surface_.local().unit, atEdge };
}

/// What the rays of the faces that meet at a sharp edge or tip tend to.
SideThickness::Value SideThickness::rayAtEdge(int point, SurfaceAnswers& surface) const
{
  Value least{ kNone };
  const glm::dvec3& tip = sites_.points()[point];
  const IncidenceLists& edges = connectivity_.pointEdges;
  for (const int* edge = edges.begin(point); edge != edges.end(point); ++edge)
  {
    const IncidenceLists& faces = connectivity_.edgeTriangles;
    for (const int* face = faces.begin(*edge); face != faces.end(*edge); ++face)
    {
      const glm::dvec3 inward = this->inwardOfFace(*face);
      if (inward == glm::dvec3(0.0))
      {
        continue;
      }
      const glm::dvec3 start = tip + kFromEdge * (this->centreOf(*face) - tip);
      const Value value = this->rayAt({ start, inward }, RayStart{ -1, *face }, surface);
      least = std::isnan(least.thickness) || value.thickness < least.thickness ? value : least;
    }
  }
  const double step = kFromEdge * this->shortestEdge(point) * surface_.local().unit;
  return least.thickness < 10.0 * step ? Value{ 0.0, true } : least;
}

glm::dvec3 SideThickness::inwardOfFace(int face) const
{
  const glm::dvec3& normal = sites_.faceNormal(face);
  return -sign_ * normal;
}

glm::dvec3 SideThickness::centreOf(int face) const
{
  const glm::ivec3& corners = sites_.faces()[face];
  return (sites_.points()[corners[0]] + sites_.points()[corners[1]] + sites_.points()[corners[2]]) /
    3.0;
}

double SideThickness::shortestEdge(int point) const
{
  double shortest = std::numeric_limits<double>::max();
  const int* end = connectivity_.pointEdges.end(point);
  for (const int* edge = connectivity_.pointEdges.begin(point); edge != end; ++edge)
  {
    const glm::ivec2& ends = sites_.edges()[*edge];
    shortest =
      std::min(shortest, glm::distance(sites_.points()[ends[0]], sites_.points()[ends[1]]));
  }
  return shortest;
}

/// How far the centre of a triangle is from its longest edge.
double SideThickness::lowestThirdOfHeight(int face) const
{
  const glm::ivec3& corners = sites_.faces()[face];
  const glm::dvec3& a = sites_.points()[corners[0]];
  const glm::dvec3& b = sites_.points()[corners[1]];
  const glm::dvec3& c = sites_.points()[corners[2]];
  const double longest =
    std::max({ glm::distance(a, b), glm::distance(b, c), glm::distance(c, a) });
  return glm::length(glm::cross(b - a, c - a)) / longest / 3.0;
}

bool SideThickness::meets(int site, const RayStart& start) const
{
  return start.point >= 0 ? this->meetsAtPoint(site, start.point)
                          : this->belongsToFace(site, start.face);
}

bool SideThickness::meetsAtPoint(int site, int point) const
{
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
    {
      const glm::ivec3& corners = sites_.faces()[site];
      return corners[0] == point || corners[1] == point || corners[2] == point;
    }
    case SiteKind::Edge:
    {
      const glm::ivec2& ends = sites_.edges()[site - sites_.firstEdge()];
      return ends[0] == point || ends[1] == point;
    }
    case SiteKind::Vertex:
      break;
  }
  return site - sites_.firstVertex() == point;
}

bool SideThickness::belongsToFace(int site, int face) const
{
  const auto isOneOf = [](const glm::ivec3& ids, int id)
  { return ids[0] == id || ids[1] == id || ids[2] == id; };
  switch (sites_.kind(site))
  {
    case SiteKind::Face:
      return site == face;
    case SiteKind::Edge:
      return isOneOf(sites_.faceEdges()[face], site - sites_.firstEdge());
    case SiteKind::Vertex:
      break;
  }
  return isOneOf(sites_.faces()[face], site - sites_.firstVertex());
}

} // namespace medial
