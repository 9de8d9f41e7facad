#include "thinning/axis_samples.h"

#include "sites/closest_point.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

/// Sets the bisector points of grid edges; the middle where the ends of one have the same closest
/// site.
void setPointsOn(const SampleContext& context, const CubicalComplex& complex, const CubeCell* faces,
  std::size_t count, BisectorPoint* points)
{
  std::vector<SiteSegment> segments;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Crossing edge = dualEdge(complex, faces[i]);
    const std::size_t far = CubicalComplex::index(faces[i]);
    const auto step = static_cast<std::size_t>(complex.stride(edge.axis));
    SiteSegment segment = segmentOf(context.geometry.frame, edge);
    segment.fromSite = context.closestSites[far - step];
    segment.toSite = context.closestSites[far];
    if (segment.fromSite != segment.toSite)
    {
      segments.push_back(segment);
      which.push_back(i);
      continue;
    }
    points[i].position = 0.5 * (segment.from + segment.to);
    points[i].a = closestPoint(context.geometry.sites, segment.fromSite, points[i].position);
    points[i].b = points[i].a;
  }
  const std::vector<BisectorPoint> found = bisectorPoints(context.geometry, segments);
  for (std::size_t k = 0; k < which.size(); ++k)
  {
    points[which[k]] = found[k];
  }
}

/// Centre of the ball that touches the surface at the closest point of x and in another place.
BisectorPoint shrunkBall(const SampleContext& context, const glm::dvec3& x, const SitePoint& foot)
{
  constexpr double kMaxRadius = 2.0;
  constexpr double kSame = 1e-6;
  constexpr int kMaxRounds = 20;
  const double distance = glm::distance(x, foot.point);
  BisectorPoint ball{ x, foot, foot };
  if (distance < kSame)
  {
    return ball;
  }
  const glm::dvec3 inwards = (x - foot.point) / distance;
  double radius = kMaxRadius;
  for (int round = 0; round < kMaxRounds; ++round)
  {
    const glm::dvec3 centre = foot.point + radius * inwards;
    const SitePoint nearest = context.geometry.query.closest(centre);
    const glm::dvec3 chord = nearest.point - foot.point;
    const double height = glm::dot(chord, inwards);
    if (glm::distance(nearest.point, centre) > radius - kSame || height < kSame)
    {
      break;
    }
    radius = 0.5 * glm::dot(chord, chord) / height;
    ball = { foot.point + radius * inwards, foot, nearest };
  }
  return ball;
}

} // namespace

CubeCell dualFace(const CubicalComplex& complex, const Crossing& crossing)
{
  glm::ivec3 position = crossing.voxel;
  ++position[crossing.axis];
  return complex.cell(position, kFaceKind + crossing.axis);
}

Crossing dualEdge(const CubicalComplex& complex, CubeCell face)
{
  Crossing edge{ complex.position(face), CubicalComplex::kind(face) - kFaceKind, -1, -1, false };
  --edge.voxel[edge.axis];
  return edge;
}

AxisSamples::AxisSamples(const CubicalComplex& complex, const std::vector<Crossing>& crossings,
  BisectorPoints bisectors)
  : samples_(std::move(bisectors))
  , ranks_(complex)
{
  byFace_.reserve(crossings.size());
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    byFace_.push_back({ dualFace(complex, crossings[i]), static_cast<int>(i) });
  }
  this->sort();
}

void AxisSamples::sort()
{
  tbb::parallel_sort(byFace_.begin(), byFace_.end(),
    [](const Entry& a, const Entry& b)
    { return std::tie(a.face, a.sample) < std::tie(b.face, b.sample); });
  ranks_.set(byFace_, faceOf);
}

void AxisSamples::add(const SampleContext& context, const CubicalComplex& complex,
  std::vector<CubeCell> faces)
{
  tbb::parallel_sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [this](CubeCell face) { return this->find(face) != kNone; }),
    faces.end());
  const std::size_t first = samples_.points.size();
  samples_.points.resize(first + faces.size());
  samples_.moved.resize(first + faces.size(), 0);
  constexpr std::size_t kTogether = 128;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, faces.size(), kTogether),
    [&](const tbb::blocked_range<std::size_t>& range)
    {
      setPointsOn(context, complex, faces.data() + range.begin(), range.size(),
        samples_.points.data() + first + range.begin());
    });
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    byFace_.push_back({ faces[i], static_cast<int>(first + i) });
  }
  this->sort();
}

int AxisSamples::addPoint(const SampleContext& context, const CubicalComplex& complex,
  const glm::ivec3& voxel)
{
  const glm::dvec3 x = context.geometry.frame.sample(glm::dvec3(voxel));
  const int site = context.closestSites[CubicalComplex::index(complex.cell(voxel, kVertexKind))];
  samples_.points.push_back(shrunkBall(context, x, closestPoint(context.geometry.sites, site, x)));
  samples_.moved.push_back(0);
  return static_cast<int>(samples_.points.size()) - 1;
}

int AxisSamples::find(CubeCell face) const
{
  const std::size_t entry = ranks_.find(face);
  return entry == CellRanks::kNone ? kNone : byFace_[entry].sample;
}

} // namespace medial
