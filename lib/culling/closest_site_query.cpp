#include "medial/culling/closest_site_query.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace medial
{
namespace
{

/// Points below which a box is not halved any more, and above which halves run in parallel.
constexpr std::ptrdiff_t kLeafPoints = 12;
constexpr std::ptrdiff_t kParallelPoints = 1024;

class PointBisection
{
public:
  PointBisection(const SiteSet& sites, const CandidateFilter& filter,
    const std::vector<glm::dvec3>& points, std::vector<SitePoint>& results)
    : sites_(sites)
    , filter_(filter)
    , points_(points)
    , results_(results)
    , order_(points.size())
  {
    std::iota(order_.begin(), order_.end(), std::size_t{ 0 });
  }

  void run() { this->descend(0, static_cast<std::ptrdiff_t>(order_.size()), filter_.allSites()); }

private:
  void descend(std::ptrdiff_t begin, std::ptrdiff_t end, const std::vector<int>& parent)
  {
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (std::ptrdiff_t i = begin; i < end; ++i)
    {
      low = glm::min(low, points_[order_[i]]);
      high = glm::max(high, points_[order_[i]]);
    }
    std::vector<int> candidates;
    CandidateFilter::Scratch scratch;
    filter_.filter(parent, { glm::vec3(0.5 * (low + high)), glm::vec3(0.5 * (high - low)) },
      candidates, scratch);
    if (end - begin <= kLeafPoints)
    {
      this->search(begin, end, candidates);
      return;
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const std::ptrdiff_t middle = (begin + end) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
      [&](std::size_t a, std::size_t b) { return points_[a][axis] < points_[b][axis]; });
    const auto lower = [&] { this->descend(begin, middle, candidates); };
    const auto upper = [&] { this->descend(middle, end, candidates); };
    if (end - begin > kParallelPoints)
    {
      tbb::parallel_invoke(lower, upper);
      return;
    }
    lower();
    upper();
  }

  void search(std::ptrdiff_t begin, std::ptrdiff_t end, const std::vector<int>& candidates)
  {
    std::vector<float> lower(candidates.size());
    for (std::ptrdiff_t i = begin; i < end; ++i)
    {
      const glm::dvec3& x = points_[order_[i]];
      float limit = std::numeric_limits<float>::max();
      for (std::size_t c = 0; c < candidates.size(); ++c)
      {
        const DistanceBounds bounds = filter_.bounds(candidates[c], glm::vec3(x));
        lower[c] = bounds.lower - filter_.slack();
        limit = std::min(limit, bounds.upper + filter_.slack());
      }
      double best = std::numeric_limits<double>::max();
      for (std::size_t c = 0; c < candidates.size(); ++c)
      {
        if (lower[c] > limit)
        {
          continue;
        }
        const SitePoint candidate = closestPoint(sites_, candidates[c], x);
        const double distance = glm::distance(candidate.point, x);
        if (distance < best)
        {
          best = distance;
          results_[order_[i]] = candidate;
        }
      }
    }
  }

  const SiteSet& sites_;
  const CandidateFilter& filter_;
  const std::vector<glm::dvec3>& points_;
  std::vector<SitePoint>& results_;
  std::vector<std::size_t> order_;
};

} // namespace

std::vector<SitePoint> closestSites(const SiteSet& sites, const CandidateFilter& filter,
  const std::vector<glm::dvec3>& points)
{
  std::vector<SitePoint> results(points.size());
  if (!points.empty())
  {
    PointBisection(sites, filter, points, results).run();
  }
  return results;
}

} // namespace medial
