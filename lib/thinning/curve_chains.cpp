#include "thinning/curve_chains.h"

#include <algorithm>
#include <cmath>

namespace medial
{
namespace
{

/// Maximum number of edges that a chord spans.
constexpr int kChord = 6;
/// The mean depth of the four voxels around a curve is smaller than the radius by this: their mean
/// distance from the curve.
constexpr float kMeanOffset = 0.75f;
/// A curve that meets a sheet sooner than the angle can be measured stays if it is so long, in
/// local units, and its radius grows by no more than this part of what the angle allows. It may be
/// the way to the end of a tube, beside faces that the fire has not taken.
constexpr float kMinStub = 1.0f;
constexpr float kBlunt = 0.5f;

} // namespace

CurveChains::CurveChains(const CurveLimits& limits)
  : slope_(static_cast<float>(std::cos(0.5 * limits.angle)))
  , minLambda_(static_cast<float>(limits.lambda))
  , minRadius_(static_cast<float>(limits.radius))
  , minLength_(static_cast<float>(limits.length))
{
}

float CurveChains::length(int chain, const glm::vec3& position) const
{
  if (chain == kNone)
  {
    return 0.0f;
  }
  const Link& link = links_[chain];
  return link.baseLength + glm::distance(position, link.base);
}

double CurveChains::arrival(int chain, const glm::vec3& position, float depth) const
{
  const float tip = chain == kNone ? depth : links_[chain].tipDepth;
  return static_cast<double>(tip + this->length(chain, position));
}

int CurveChains::extend(int chain, const Pair& removed, const glm::vec3& position, float depth)
{
  const int index = static_cast<int>(links_.size());
  const float length = this->length(chain, position);
  Link link{ removed, chain, index, length, this->potential(depth, length), depth, position, length,
    0 };
  if (chain != kNone)
  {
    const Link& last = links_[chain];
    link.tipDepth = last.tipDepth;
    if (links_[last.best].potential >= link.potential)
    {
      link.best = last.best;
    }
    if (last.sinceBase < kChord)
    {
      link.base = last.base;
      link.baseLength = last.baseLength;
      link.sinceBase = last.sinceBase + 1;
    }
  }
  links_.push_back(link);
  return index;
}

bool CurveChains::largeEnough(float depth, float slope) const
{
  const float radius = depth + kMeanOffset;
  const float cosine = std::clamp(slope, 0.0f, 1.0f);
  return radius >= minRadius_ && radius * std::sqrt(1.0f - cosine * cosine) >= minLambda_;
}

bool CurveChains::descends(int chain, const glm::vec3& position, float depth) const
{
  constexpr float kSlope = 0.5f; // from a centre to the surface it is 1
  return chain != kNone && links_[chain].tipDepth - depth >= kSlope * this->length(chain, position);
}

bool CurveChains::lasting(int chain, const glm::vec3& position, float depth, bool goesOn,
  std::vector<Pair>& restored) const
{
  const float length = this->length(chain, position);
  const float minLength = goesOn ? minLength_ : std::min(kMinStub, minLength_);
  int far = chain;
  while (far != kNone && length - links_[far].length < minLength)
  {
    far = links_[far].previous;
  }
  if (far == kNone)
  {
    return false;
  }
  const int start = links_[far].best;
  const float startDepth = links_[start].potential + slope_ * links_[start].length;
  const float along = length - links_[start].length;
  const float slope = (depth - startDepth) / along;
  const float steepest = along < minLength_ ? kBlunt * slope_ : slope_;
  if (slope > steepest || !this->largeEnough(depth, slope))
  {
    return false;
  }
  for (int link = chain; link != links_[start].previous; link = links_[link].previous)
  {
    restored.push_back(links_[link].removed);
  }
  return true;
}

} // namespace medial
