#include "field/engines/device/self_check.h"

#include "medial/error.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <sstream>

namespace medial
{
namespace
{

constexpr double kPoints = 1000.0;
/// Error of a distance that every engine keeps to, local units, for points that are not far away.
constexpr double kTolerance = 1e-2;

std::atomic<bool> isTrusted{ false };

} // namespace

SelfCheck::SelfCheck(const FieldJob& job, const Device& device)
  : job_(job)
  , device_(device.renderer + ", " + device.version)
{
  if (job.verify || (!device.software && !isTrusted))
  {
    share_ = kPoints / std::max(static_cast<double>(job.extent.pointCount()), kPoints);
  }
}

std::uint64_t SelfCheck::random()
{
  state_ ^= state_ << 13;
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  return state_;
}

void SelfCheck::check(const Extent& slab, const ResolvedSlab& values)
{
  const auto points = static_cast<std::uint64_t>(slab.pointCount());
  // All in the first slab, before anything is stored, and then a share.
  const double wanted = isFirst_ && this->isDue() ? kPoints : share_ * static_cast<double>(points);
  const int count = static_cast<int>(std::ceil(wanted));
  isFirst_ = false;
  const auto row = static_cast<std::uint64_t>(slab.size(0));
  const std::uint64_t slice = row * static_cast<std::uint64_t>(slab.size(1));
  for (int i = 0; i < count; ++i)
  {
    const std::uint64_t at = this->random() % points;
    const glm::dvec3 x = job_.frame.sample(glm::dvec3(slab.min[0], slab.min[1], slab.min[2]) +
      glm::dvec3(at % row, at % slice / row, at / slice));
    const double exact = glm::distance(job_.host.query().closest(x).point, x);
    const double found =
      std::abs(static_cast<double>(*values.distances.at(static_cast<std::int64_t>(at))));
    if (!(std::abs(found - exact) <= kTolerance))
    {
      std::ostringstream message;
      message << "the device computed a wrong field (" << device_ << "): " << found
              << " instead of " << exact << " times the finest spacing";
      throw Error(ErrorCode::NoGpu, message.str());
    }
  }
}

void SelfCheck::passed() const
{
  isTrusted = isTrusted || this->isDue();
}

} // namespace medial
