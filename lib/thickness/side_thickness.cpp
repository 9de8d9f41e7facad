#include "thickness/side_thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
/// Margin for LocalCoordinates::around().
constexpr double kMargin = 0.0;
/// Rays of an edge start this share of the way from it to the middle of each of its faces.
constexpr double kFromEdge = 1e-6;

double angleOf(const ThicknessOptions& options)
{
  return options.method == ThicknessMethod::Wall ? std::max(options.angle, kMinWallAngle)
                                                 : options.angle;
}

} // namespace

SideThickness::SideThickness(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const ThicknessOptions& options)
  : connectivity_(connectivity)
  , surface_(mesh, connectivity, kMargin)
  , method_(options.method)
  , angle_(angleOf(options))
  , tellsEdges_(options.cells)
  , diagonal_(mesh.bounds().diagonal() / surface_.local().unit)
  , sites_(surface_.sites())
  , ball_(surface_, angle_, diagonal_)
  , bend_(surface_, kMaxBend, diagonal_)
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
  if (tellsEdges_)
  {
    edges_.emplace(sites_, bends);
  }
}

SideThickness::Value SideThickness::atPoint(int point, double guess) const
{
  if (inward_[point] == glm::dvec3(0.0))
  {
    return { kNone };
  }
  const TouchingBall::Ray ray{ sites_.points()[point], inward_[point] };
  if (method_ == ThicknessMethod::Ray)
  {
    return sharp_[point]
      ? this->rayAtEdge(point)
      : this->rayAt(ray,
          [&](int face)
          {
            const glm::ivec3& corners = sites_.faces()[face];
            return corners[0] == point || corners[1] == point || corners[2] == point;
          });
  }
  if (sharp_[point])
  {
    return { 0.0, true };
  }
  if (method_ == ThicknessMethod::Wall && bent_[point])
  {
    return { kNone }; // the walls are those of the faces beside it
  }
  return this->ballAt(ray, kFirstShare * this->shortestEdge(point), guess,
    [&](int site) { return this->meetsAtPoint(site, point); });
}

SideThickness::Value SideThickness::atTriangle(int triangle, double guess) const
{
  const glm::dvec3 inward = this->inwardOfFace(triangle);
  if (inward == glm::dvec3(0.0))
  {
    return { kNone };
  }
  const TouchingBall::Ray ray{ this->centreOf(triangle), inward };
  if (method_ == ThicknessMethod::Ray)
  {
    return this->rayAt(ray, [&](int face) { return face == triangle; });
  }
  return this->ballAt(ray, kFirstShare * this->lowestThirdOfHeight(triangle), guess,
    [&](int site) { return this->belongsToFace(site, triangle); });
}

template <typename Touches>
SideThickness::Value SideThickness::ballAt(const TouchingBall::Ray& ray, double first, double guess,
  const Touches& touches) const
{
  const double unit = surface_.local().unit;
  const double position = guess > 0.0 ? kGuess * guess / unit : ball_.reach();
  const std::optional<TouchingBall::Ball> ball = this->touchingBall(ray, first, position, touches);
  if (!ball)
  {
    return { kNone };
  }
  const glm::dvec3 centre = ray.start + ball->position * ray.direction;
  const bool atEdge = edges_ &&
    (ball->radius == 0.0 ||
      edges_->explain(ray.start, -ray.direction, ball->opposite,
        (ball->opposite - centre) / ball->radius));
  // The way to the wall through the ball's centre: its diameter, if the ball touches the start.
  const double thickness =
    method_ == ThicknessMethod::Wall ? ball->position + ball->radius : 2.0 * ball->radius;
  return { thickness * unit, atEdge };
}

/// A ball on the other side of the surface opposite does not touch the start, nor does one that is
/// not far enough from a wall to touch the start, and sees this wall under less than the angle,
/// does not count. Neighbouring facets are no such wall.
template <typename Touches>
std::optional<TouchingBall::Ball> SideThickness::touchingBall(const TouchingBall::Ray& ray,
  double first, double guess, const Touches& touches) const
{
  if (angle_ <= kMaxBend)
  {
    return ball_.find(ray, first, guess, touches);
  }
  const std::optional<TouchingBall::Ball> bent = bend_.find(ray, first, guess, touches);
  if (!bent)
  {
    return std::nullopt;
  }
  const double touching = method_ == ThicknessMethod::Wall ? kTouchingWall : kTouching;
  if (bent->position > 0.0)
  {
    TouchingBall::Ray close = ray;
    close.minCloseness = touching * std::min(bent->startCloseness, bent->closeness);
    const auto exit = opposite_->find(HalfLine(ray.start, ray.direction), sign_,
      [&](int face) { return touches(face); });
    const double end = exit ? exit->distance : ball_.reach();
    return end > bent->position ? ball_.findBehind(close, *bent, end) : std::nullopt;
  }
  const std::optional<TouchingBall::Ball> ball = ball_.find(ray, first, guess, touches);
  return ball && ball->closeness >= touching * ball->startCloseness ? ball : std::nullopt;
}

template <typename Skips>
SideThickness::Value SideThickness::rayAt(const TouchingBall::Ray& ray, const Skips& skips) const
{
  const auto hit = opposite_->find(HalfLine(ray.start, ray.direction), sign_, skips);
  if (!hit)
  {
    return { kNone };
  }
  const bool atEdge = edges_ &&
    edges_->explain(ray.start, -ray.direction, ray.start + hit->distance * ray.direction,
      -this->inwardOfFace(hit->face));
  return { hit->distance * surface_.local().unit, atEdge };
}

/// What the rays of the faces that meet at a sharp edge or tip tend to.
SideThickness::Value SideThickness::rayAtEdge(int point) const
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
      const Value value = this->rayAt({ start, inward }, [&](int other) { return other == *face; });
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
