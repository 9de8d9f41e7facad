#include "axis/sheets/sheet_fit.h"

#include "base/sorted_set.h"
#include "base/vectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace medial
{
namespace
{

/// Samples farther away than this, in grid steps, have no weight.
constexpr double kReach = 3.0;
/// Samples within a strip of about this width (voxels) tell nothing about the change across it.
constexpr double kMinSpread = 0.3;

/// Solves (uu uv; uv vv) x = b, by least squares where the samples lie on a line.
glm::dvec2 solved(const glm::dvec3& squares, const glm::dvec2& b)
{
  const double uu = squares.x;
  const double uv = squares.y;
  const double vv = squares.z;
  const double mean = 0.5 * (uu + vv);
  const double spread = std::hypot(0.5 * (uu - vv), uv);
  if (mean - spread > kMinSpread * kMinSpread)
  {
    return glm::dvec2(b.x * vv - b.y * uv, b.y * uu - b.x * uv) / (uu * vv - uv * uv);
  }
  const double large = mean + spread;
  if (large <= kMinSpread * kMinSpread)
  {
    return glm::dvec2(0.0);
  }
  // The eigenvector of the larger eigenvalue.
  const glm::dvec2 along =
    glm::normalize(uu >= vv ? glm::dvec2(large - vv, uv) : glm::dvec2(uv, large - uu));
  return glm::dot(along, b) / large * along;
}

} // namespace

SheetFitter::SheetFitter(const GridFrame& frame, double angle, const SheetSamples& samples)
  : perStep_(1.0 / frame.step)
  , cosAngle_(std::cos(angle))
  , samples_(samples)
  , visited_(samples.points.size(), 0)
  , done_(samples.mesh.cells.size(), 0)
{
}

double SheetFitter::weightOf(std::size_t crossing, const glm::dvec3& position) const
{
  if (samples_.kinds[crossing] != SampleKind::Exact)
  {
    return 0.0;
  }
  const glm::dvec3 steps = perStep_ * position;
  const double squared = glm::dot(steps, steps);
  if (squared >= kReach * kReach)
  {
    return 0.0;
  }
  const double rest = 1.0 - squared / (kReach * kReach);
  return rest * rest;
}

/// Adds the samples around a vertex that are on the sheet of a node. Returns whether it is clear of
/// all of them, from any node, that they are or never count.
bool SheetFitter::reach(const PairDirections& from, std::uint32_t vertex, const glm::dvec3& x)
{
  static const double kCosTurn = std::cos(glm::radians(kMaxTurn));
  const DualMesh& mesh = samples_.mesh;
  std::uint32_t* const visited = visited_.data();
  const std::uint32_t fit = fit_;
  bool done = true;
  const std::uint32_t* const end = mesh.incident.data() + mesh.offsets[vertex + 1];
  for (const std::uint32_t* at = mesh.incident.data() + mesh.offsets[vertex]; at != end; ++at)
  {
    const std::uint32_t crossing = *at;
    if (visited[crossing] == fit)
    {
      continue;
    }
    const glm::dvec3 position = samples_.positions[crossing] - x;
    const double weight = this->weightOf(crossing, position);
    if (weight == 0.0)
    {
      visited[crossing] = fit;
      continue;
    }
    const PairDirections& directions = samples_.directions[crossing];
    const Match match = matchOf(from, directions, kCosTurn);
    if (match == Match::None)
    {
      done = false;
      continue;
    }
    visited[crossing] = fit;
    nodes_.push_back({ directions, crossing, position, weight });
    if (match == Match::Swapped)
    {
      std::swap(nodes_.back().towardsA, nodes_.back().towardsB);
    }
  }
  return done;
}

void SheetFitter::gather(const glm::dvec3& x, std::size_t crossing)
{
  const DualMesh& mesh = samples_.mesh;
  ++fit_;
  nodes_.clear();
  visited_[crossing] = fit_;
  const glm::dvec3 position = samples_.positions[crossing] - x;
  nodes_.push_back(
    { samples_.directions[crossing], crossing, position, this->weightOf(crossing, position) });
  for (std::size_t k = 0; k < nodes_.size(); ++k)
  {
    const PairDirections from = nodes_[k];
    for (const std::uint32_t vertex : mesh.corners[nodes_[k].crossing])
    {
      if (done_[vertex] != fit_ && this->reach(from, vertex, x))
      {
        done_[vertex] = fit_;
      }
    }
  }
}

std::vector<int> SheetFitter::sites() const
{
  std::vector<int> sites;
  for (const Node& node : nodes_)
  {
    const BisectorPoint& point = samples_.points[node.crossing];
    for (const int site : { point.a.site, point.b.site })
    {
      // Neighbours have mostly the same.
      if (std::find(sites.end() - std::min<std::ptrdiff_t>(sites.end() - sites.begin(), 4),
            sites.end(), site) == sites.end())
      {
        sites.push_back(site);
      }
    }
  }
  makeSet(sites);
  return sites;
}

SheetFit SheetFitter::around(const glm::dvec3& x, std::size_t crossing)
{
  this->gather(x, crossing);
  SheetFit fit;
  if (this->average(fit))
  {
    this->fitLines(fit);
  }
  return fit;
}

/// Sets the means over the nodes. Returns whether there are any.
bool SheetFitter::average(SheetFit& fit) const
{
  double weight = 0.0;
  for (const Node& node : nodes_)
  {
    fit.samples += node.weight > 0.0 ? 1 : 0;
    weight += node.weight;
    fit.centroid += node.weight * node.position;
    fit.towardsA += node.weight * node.towardsA;
    fit.towardsB += node.weight * node.towardsB;
  }
  const glm::dvec3 across = fit.towardsB - fit.towardsA;
  if (weight == 0.0 || glm::length(across) == 0.0)
  {
    fit.samples = 0;
    return false;
  }
  fit.weight = weight;
  fit.centroid /= weight;
  fit.towardsA = glm::normalize(fit.towardsA);
  fit.towardsB = glm::normalize(fit.towardsB);
  fit.normal = glm::normalize(across);
  return true;
}

/// Sets the linear functions, whose means are known.
void SheetFitter::fitLines(SheetFit& fit) const
{
  const auto [alongU, alongV] = normalsTo(fit.normal);
  glm::dvec3 squares(0.0); // uu, uv, vv
  glm::dvec4 values(0.0);  // cosine, excess, radius, lambda
  glm::dvec4 withU(0.0);
  glm::dvec4 withV(0.0);
  for (const Node& node : nodes_)
  {
    const double w = node.weight / fit.weight;
    const double u = glm::dot(node.position - fit.centroid, alongU);
    const double v = glm::dot(node.position - fit.centroid, alongV);
    const double excess =
      node.radius * node.radius * (glm::dot(node.towardsA, node.towardsB) - cosAngle_);
    const glm::dvec4 value(0.5 * glm::length(node.towardsA + node.towardsB), excess, node.radius,
      0.5 * node.radius * glm::length(node.towardsB - node.towardsA));
    squares += w * glm::dvec3(u * u, u * v, v * v);
    values += w * value;
    withU += w * u * value;
    withV += w * v * value;
  }
  const glm::dvec2 x(-glm::dot(fit.centroid, alongU), -glm::dot(fit.centroid, alongV));
  SheetFit::Linear* const functions[] = { &fit.cosine, &fit.excess, &fit.radius, &fit.lambda };
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec2 slope = solved(squares, { withU[i], withV[i] });
    functions[i]->value = values[i] + glm::dot(slope, x);
    functions[i]->gradient = slope.x * alongU + slope.y * alongV;
  }
}

} // namespace medial
