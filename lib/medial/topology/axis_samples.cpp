#include "medial/medial/topology/axis_samples.h"

#include "medial/medial/bisector.h"
#include "medial/medial/separation.h"

#include <algorithm>
#include <tuple>

namespace medial
{
namespace
{

glm::dvec3 farEnd(const GridFrame& frame, const Crossing& crossing)
{
  glm::dvec3 end(crossing.voxel);
  end[crossing.axis] += 1.0;
  return frame.sample(end);
}

/// Bisector points of all edges; the middle of those that have none.
std::vector<glm::dvec3> pointsOn(const SampleContext& context, std::vector<Crossing>& edges)
{
  std::vector<Crossing> crossed;
  for (const Crossing& edge : edges)
  {
    if (edge.siteA != edge.siteB)
    {
      crossed.push_back(edge);
    }
  }
  const std::vector<glm::dvec3> found =
    bisectorPoints(context.sites, context.frame, context.query, crossed);
  std::vector<glm::dvec3> points;
  std::size_t next = 0; // in `crossed`, which is in the order of `edges`
  for (Crossing& edge : edges)
  {
    if (next < crossed.size() && crossed[next].voxel == edge.voxel &&
      crossed[next].axis == edge.axis)
    {
      edge = crossed[next];
      points.push_back(found[next++]);
      continue;
    }
    points.push_back(
      0.5 * (context.frame.sample(glm::dvec3(edge.voxel)) + farEnd(context.frame, edge)));
  }
  return points;
}

/// A ball that touches the surface in two places.
struct Ball
{
  glm::dvec3 centre;
  int opposite; ///< site of the second place; -1 where there is none near enough
};

/// @param foot closest surface point of x.
Ball shrunkBall(const SampleContext& context, const CellLattice& lattice, const glm::dvec3& x,
  const glm::dvec3& foot)
{
  constexpr double kMostRadius = 2.0;
  constexpr double kSame = 1e-6;
  constexpr int kMaxRounds = 20;
  const double distance = glm::distance(x, foot);
  if (distance < kSame)
  {
    return { x, -1 };
  }
  // Queries are exact inside the grid only.
  const glm::dvec3 low = context.frame.sample(glm::dvec3(0.0));
  const glm::dvec3 high = context.frame.sample(glm::dvec3(lattice.size() - 1));
  const glm::dvec3 inwards = (x - foot) / distance;
  Ball ball{ x, -1 };
  double radius = kMostRadius;
  for (int round = 0; round < kMaxRounds; ++round)
  {
    const glm::dvec3 centre = foot + radius * inwards;
    const SitePoint nearest = context.query.closest(glm::clamp(centre, low, high), radius);
    const glm::dvec3 chord = nearest.point - foot;
    const double height = glm::dot(chord, inwards);
    if (glm::distance(nearest.point, centre) > radius - kSame || height < kSame)
    {
      break;
    }
    radius = 0.5 * glm::dot(chord, chord) / height;
    ball = { foot + radius * inwards, nearest.site };
  }
  return ball;
}

} // namespace

Cell dualFace(const CellLattice& lattice, const Crossing& crossing)
{
  glm::ivec3 position = crossing.voxel;
  ++position[crossing.axis];
  return lattice.cell(position, kFaceKind + crossing.axis);
}

Crossing dualEdge(const CellLattice& lattice, Cell face)
{
  Crossing edge{ lattice.position(face), CellLattice::kind(face) - kFaceKind, -1, -1 };
  --edge.voxel[edge.axis];
  return edge;
}

AxisSamples::AxisSamples(const CellLattice& lattice, const std::vector<Crossing>& crossings,
  const std::vector<glm::dvec3>& points)
  : crossings_(crossings)
  , points_(points)
{
  this->sortFrom(0, lattice);
}

void AxisSamples::sortFrom(std::size_t first, const CellLattice& lattice)
{
  for (std::size_t i = first; i < crossings_.size(); ++i)
  {
    byFace_.push_back({ dualFace(lattice, crossings_[i]), static_cast<int>(i) });
  }
  std::sort(byFace_.begin(), byFace_.end(),
    [](const Entry& a, const Entry& b)
    { return std::tie(a.face, a.sample) < std::tie(b.face, b.sample); });
}

void AxisSamples::add(const SampleContext& context, const CellLattice& lattice,
  std::vector<Cell> faces)
{
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<Crossing> edges;
  for (const Cell face : faces)
  {
    if (this->find(face) == kNone)
    {
      const std::size_t far = CellLattice::index(face);
      Crossing edge = dualEdge(lattice, face);
      edge.siteA = context.closestSites[far - static_cast<std::size_t>(lattice.stride(edge.axis))];
      edge.siteB = context.closestSites[far];
      edges.push_back(edge);
    }
  }
  const std::vector<glm::dvec3> points = pointsOn(context, edges);
  const std::size_t first = crossings_.size();
  crossings_.insert(crossings_.end(), edges.begin(), edges.end());
  points_.insert(points_.end(), points.begin(), points.end());
  this->sortFrom(first, lattice);
}

int AxisSamples::addPoint(const SampleContext& context, const CellLattice& lattice,
  const glm::ivec3& voxel)
{
  const glm::dvec3 x = context.frame.sample(glm::dvec3(voxel));
  const std::int32_t site =
    context.closestSites[CellLattice::index(lattice.cell(voxel, kVertexKind))];
  const SitePoint closest = closestPoint(context.sites, site, x);
  const Ball ball = shrunkBall(context, lattice, x, closest.point);
  crossings_.push_back({ voxel, 0, site, ball.opposite >= 0 ? ball.opposite : site });
  points_.push_back(ball.centre);
  return static_cast<int>(crossings_.size()) - 1;
}

int AxisSamples::find(Cell face) const
{
  const auto found = std::lower_bound(byFace_.begin(), byFace_.end(), face,
    [](const Entry& entry, Cell wanted) { return entry.face < wanted; });
  return found != byFace_.end() && found->face == face ? found->sample : kNone;
}

double AxisSamples::angle(const SiteSet& sites, int sample) const
{
  const Crossing& crossing = crossings_[sample];
  const glm::dvec3& x = points_[sample];
  return separationAngle(x, closestPoint(sites, crossing.siteA, x).point,
    closestPoint(sites, crossing.siteB, x).point);
}

} // namespace medial
