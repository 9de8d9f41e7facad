#include "skeleton/branch_ends.h"

#include "skeleton/sheet_fire.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace medial
{
namespace
{

/// A branch ends where the radius falls by this part of the length.
constexpr double kFall = 0.5;
/// How far a free end is looked for, in radii and steps.
constexpr double kEndOfRadius = 2.5;
constexpr double kEndSteps = 6.0;
/// The length over which the radius must fall by less than half of it where a branch ends: in
/// steps, and as a part of the radius.
constexpr double kEndRun = 6.0;
constexpr double kEndRunOfRadius = 0.5;
/// How much of a free end is made anew, in radii and steps: a fire leaves curves on the sheets
/// there.
constexpr double kCutOfRadius = 0.5;
constexpr double kCutSteps = 2.0;
/// Least length of the line that tells a free end's direction, in steps.
constexpr double kLineSteps = 6.0;

class BranchEnds
{
public:
  BranchEnds(const SolidProbe& probe, double step)
    : probe_(probe)
    , step_(step)
  {
  }

  /// Moves the last point of a curve to the end of the branch.
  void finishLast(Curve& curve, bool anew) const
  {
    this->cutFalling(curve);
    // Within a sheet the radius does not tell where a branch ends.
    const std::size_t tube = this->tubePoints(curve);
    if (tube == 0)
    {
      return;
    }
    curve.points.resize(tube);
    curve.widths.resize(tube);
    const double radius = probe_.radius(curve.points.back());
    this->cutBack(curve, kCutSteps * step_ + (anew ? kCutOfRadius * radius : 0.0));
    const glm::dvec3 last = curve.points.back();
    const double reach = kEndOfRadius * radius + kEndSteps * step_;
    const glm::dvec3 direction = this->endDirection(curve, std::max(kLineSteps * step_, radius));
    const auto at = [&](double s) { return last + s * direction; };
    const double end = probe_.end(at, 0.0, probe_.wayOut(last, direction, reach), 0.5 * step_);
    curve.points.push_back(at(end));
    curve.widths.push_back(curve.widths.back());
    curve = resampled(curve, step_);
  }

private:
  /// Takes away the end of a curve where the radius falls by half of the length or more: it runs on
  /// a sheet to the surface.
  void cutFalling(Curve& curve) const
  {
    const std::vector<double> lengths = arcLengths(curve);
    std::size_t end = curve.points.size() - 1;
    double radiusAtEnd = probe_.radius(curve.points[end]);
    for (std::size_t i = end; i-- > 0;)
    {
      const double way = lengths[end] - lengths[i];
      const double radius = probe_.radius(curve.points[i]);
      if (radius - radiusAtEnd > kFall * way)
      {
        end = i;
        radiusAtEnd = radius;
      }
      else if (way >= std::max(kEndRun * step_, kEndRunOfRadius * radiusAtEnd))
      {
        break;
      }
    }
    end = std::max<std::size_t>(end, 1);
    curve.points.resize(end + 1);
    curve.widths.resize(end + 1);
  }

  /// Returns how many points of a curve are left without the end where it leaves a tube for a
  /// sheet, or 0 if there is no tube within the last width.
  std::size_t tubePoints(const Curve& curve) const
  {
    double length = 0.0;
    for (std::size_t i = curve.points.size(); i-- > 1 && length <= curve.widths.back();)
    {
      if (curve.widths[i] <= kTubeWidth * probe_.radius(curve.points[i]))
      {
        return i + 1;
      }
      length += glm::distance(curve.points[i], curve.points[i - 1]);
    }
    return 0;
  }

  /// Shortens a curve by a length, but by no more than half.
  void cutBack(Curve& curve, double length) const
  {
    const std::vector<double> lengths = arcLengths(curve);
    const double left = lengths.back() - std::min(length, 0.5 * lengths.back());
    while (curve.points.size() > 2 && lengths[curve.points.size() - 1] > left)
    {
      curve.points.pop_back();
      curve.widths.pop_back();
    }
  }

  /// Returns the direction in which a curve ends, a unit vector: that of the line nearest to the
  /// points of its end.
  glm::dvec3 endDirection(const Curve& curve, double length) const
  {
    const int count = static_cast<int>(curve.points.size());
    const int used = std::clamp(static_cast<int>(length / step_), 2, count);
    glm::dvec3 slope(0.0);
    for (int i = 0; i < used; ++i)
    {
      slope += (0.5 * (used - 1) - i) * curve.points[count - 1 - i];
    }
    return glm::normalize(slope);
  }

  const SolidProbe& probe_;
  double step_;
};

} // namespace

void finishEnds(NetworkBranch& branch, const SolidProbe& probe, double step, bool anew)
{
  const BranchEnds ends(probe, step);
  if (branch.curve.closed || branch.junctions[1] != NetworkBranch::kFree)
  {
    return;
  }
  ends.finishLast(branch.curve, anew);
  if (branch.junctions[0] == NetworkBranch::kFree)
  {
    reverse(branch.curve);
    ends.finishLast(branch.curve, anew);
    reverse(branch.curve);
  }
}

} // namespace medial
