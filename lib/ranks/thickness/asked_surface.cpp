#include "ranks/thickness/asked_surface.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace medial
{

SurfaceAnswer AskedSurface::ask(SurfaceQuestion question)
{
  if (next_ < known_.size())
  {
    return known_[next_++];
  }
  const SurfaceAnswer own = part_.answer(question);
  const bool isYesOrNo = question.kind == SurfaceQuestion::Kind::ConvexEdge ||
    question.kind == SurfaceQuestion::Kind::Seam;
  if (!isYesOrNo && own.found())
  {
    // Others at the same distance may have a lower number.
    question.limit = std::min(question.limit, ThicknessPart::roundedUp(own.distance));
  }
  std::vector<int> ranks = part_.ranksToAsk(question, own);
  if (!ranks.empty())
  {
    open_ = { question, own, std::move(ranks) };
    throw Unanswered();
  }
  known_.push_back(own);
  ++next_;
  return own;
}

SitePoint AskedSurface::closest(const glm::dvec3& x, double limit)
{
  const SurfaceAnswer answer =
    this->ask({ x, glm::dvec3(0.0), limit, SurfaceQuestion::Kind::Closest, {} });
  return answer.found() ? SitePoint{ part_.siteOf(answer.number), answer.vector } : SitePoint{};
}

std::optional<RayEnd> AskedSurface::opposite(const HalfLine& ray, const RayStart& start)
{
  constexpr double kAnywhere = std::numeric_limits<double>::infinity();
  const SurfaceAnswer answer = this->ask({ ray.from(), ray.direction(), kAnywhere,
    SurfaceQuestion::Kind::Opposite, part_.numbered(start) });
  return answer.found()
    ? std::optional(RayEnd{ answer.distance, part_.faceOf(answer.number), answer.vector })
    : std::nullopt;
}

bool AskedSurface::nearConvexEdge(const glm::dvec3& x, double distance)
{
  return this->ask({ x, glm::dvec3(0.0), distance, SurfaceQuestion::Kind::ConvexEdge, {} }).found();
}

bool AskedSurface::isSeam(const glm::dvec3& place, const glm::dvec3& direction)
{
  return part_.hasBorders() &&
    this->ask({ place, direction, part_.seamTolerance(), SurfaceQuestion::Kind::Seam, {} }).found();
}

} // namespace medial
