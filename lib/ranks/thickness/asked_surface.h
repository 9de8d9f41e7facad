#pragma once

#include "ranks/thickness/thickness_part.h"
#include "thickness/surface_answers.h"

#include <cstddef>
#include <vector>

namespace medial
{

/// A question that other ranks must help to answer.
struct OpenQuestion
{
  SurfaceQuestion question;
  SurfaceAnswer answer; ///< the best so far
  std::vector<int> ranks;
};

/// Leaves a computation that needs other ranks' answers. Once these are there it starts again.
struct Unanswered
{
};

/// Answers about the whole of a distributed surface: those that are known from before, in their
/// order, and then those that this rank can give alone.
class AskedSurface : public SurfaceAnswers
{
public:
  /// All must outlive this.
  /// @param known answers of a computation so far, to which new ones are added.
  /// @param open set where Unanswered is thrown.
  AskedSurface(const ThicknessPart& part, std::vector<SurfaceAnswer>& known, OpenQuestion& open)
    : part_(part)
    , known_(known)
    , open_(open)
  {
  }

  ///@{
  /// @throws Unanswered.
  SitePoint closest(const glm::dvec3& x, double limit) override;
  std::optional<RayEnd> opposite(const HalfLine& ray, const RayStart& start) override;
  bool nearConvexEdge(const glm::dvec3& x, double distance) override;
  bool isSeam(const glm::dvec3& place, const glm::dvec3& direction) override;
  ///@}

private:
  SurfaceAnswer ask(SurfaceQuestion question);

  const ThicknessPart& part_;
  std::vector<SurfaceAnswer>& known_;
  OpenQuestion& open_;
  std::size_t next_ = 0;
};

} // namespace medial
