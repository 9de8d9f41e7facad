#include "axis/seams/curve_balls.h"

#include "axis/bisector.h"
#include "axis/tile_order.h"
#include "base/sorted_set.h"

#include <algorithm>
#include <array>

namespace medial
{
namespace
{

/// Balls go away from the closest point of the surface, by ever shorter steps, in voxels.
constexpr double kFirstStep = 0.4;
constexpr double kShorter = 0.75;
constexpr int kSteps = 18;
/// Smaller balls do not move, voxels.
constexpr double kMinBall = 0.02;
/// Balls farther apart are not joined, voxels.
constexpr double kMaxGap = 2.5;
/// By how much the ball between two may be smaller than their mean, voxels.
constexpr double kMaxSag = 0.03;

using Edge = std::array<std::uint32_t, 2>;

BisectorPoint widestPoint(const SeamCells& cells, std::size_t vertex)
{
  BisectorPoint widest = cells.knownPoint(vertex);
  cells.forPoints(vertex,
    [&](const BisectorPoint& point)
    {
      if (point.radius() > widest.radius())
      {
        widest = point;
      }
    });
  return widest;
}

/// A ball on its way to a curve.
struct WideningBall
{
  BisectorPoint start;
  BisectorPoint widest;
};

void widen(const AxisGeometry& geometry, std::vector<WideningBall>& balls)
{
  std::vector<SiteQuery::Question> questions;
  for (const WideningBall& ball : balls)
  {
    questions.push_back({ ball.start.position, ball.start.a });
  }
  double step = kFirstStep;
  for (int k = 0; k < kSteps; ++k, step *= kShorter)
  {
    geometry.query.closest(questions);
    for (std::size_t i = 0; i < balls.size(); ++i)
    {
      SiteQuery::Question& question = questions[i];
      const SitePoint& closest = question.closest;
      const double radius = glm::distance(closest.point, question.x);
      if (radius > balls[i].widest.radius() && geometry.insideGrid(question.x))
      {
        balls[i].widest = { question.x, closest, closest };
      }
      if (radius > kMinBall)
      {
        question.x += (question.x - closest.point) * (step / radius);
        question.closest = closestPoint(geometry.sites, closest.site, question.x);
      }
    }
  }
}

std::vector<Edge> neighbours(const SeamCells& cells, const std::vector<std::uint32_t>& vertices)
{
  std::vector<std::uint32_t> numbers(cells.mesh().cells.size(), 0); // of the balls, from 1 on
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    numbers[vertices[i]] = static_cast<std::uint32_t>(i + 1);
  }
  std::vector<Edge> edges;
  for (const auto& corners : cells.mesh().corners)
  {
    for (int k = 0; k < 4; ++k)
    {
      const std::uint32_t p = numbers[corners[k]];
      const std::uint32_t q = numbers[corners[(k + 1) % 4]];
      if (p != 0 && q != 0 && p != q)
      {
        edges.push_back({ std::min(p, q) - 1, std::max(p, q) - 1 });
      }
    }
  }
  makeSet(edges);
  return edges;
}

/// Replaces edges whose balls do not lie along one curve by {p, p}.
/// @param points the balls.
void dropOthers(const AxisGeometry& geometry, const std::vector<BisectorPoint>& points, Edge* begin,
  Edge* end)
{
  const std::vector<SiteQuery::Question> questions = closestToMiddles(geometry, points, begin, end);
  for (std::size_t e = 0; e < questions.size(); ++e)
  {
    const BisectorPoint& p = points[begin[e][0]];
    const BisectorPoint& q = points[begin[e][1]];
    const double between = glm::distance(questions[e].closest.point, questions[e].x);
    if (glm::distance(p.position, q.position) >= kMaxGap ||
      between <= 0.5 * (p.radius() + q.radius()) - kMaxSag)
    {
      begin[e][1] = begin[e][0];
    }
  }
}

} // namespace

BallMesh ballsOfCurves(const AxisGeometry& geometry, const SeamCells& cells,
  const std::vector<std::uint32_t>& vertices)
{
  std::vector<BisectorPoint> points(vertices.size());
  inBlocks(geometry, vertices.size(),
    [&](std::size_t begin, std::size_t end)
    {
      std::vector<WideningBall> balls;
      for (std::size_t i = begin; i != end; ++i)
      {
        const BisectorPoint start = widestPoint(cells, vertices[i]);
        balls.push_back({ start, start });
      }
      widen(geometry, balls);
      for (std::size_t i = begin; i != end; ++i)
      {
        const WideningBall& ball = balls[i - begin];
        const bool isAcross =
          geometry.isAcross(ball.start.position, ball.start.radius(), ball.widest);
        points[i] = isAcross ? ball.start : ball.widest;
      }
    });
  BallMesh mesh;
  mesh.edges = neighbours(cells, vertices);
  inBlocks(geometry, mesh.edges.size(),
    [&](std::size_t begin, std::size_t end)
    { dropOthers(geometry, points, mesh.edges.data() + begin, mesh.edges.data() + end); });
  for (std::uint32_t ball = 0; ball < points.size(); ++ball)
  {
    mesh.balls.push_back({ points[ball].position, points[ball].radius() });
    mesh.edges.push_back({ ball, ball });
  }
  return mesh;
}

} // namespace medial
