#include "thinning/thinning.h"

#include <algorithm>
#include <array>
#include <utility>

namespace medial
{
namespace
{

/// Local units. Voxels in one bucket burn in the order in which the fire reached them.
constexpr double kBucketWidth = 0.125;
/// Replaces the chain of an edge that belongs to no curve.
constexpr int kNoCurve = -2;

} // namespace

Thinning::Thinning(CubicalComplex& complex, DepthAt depthAt, EdgeTest separates,
  const glm::dvec3& step, const CurveLimits& limits, const Checkpoint& checkpoint)
  : complex_(complex)
  , anchors_(complex.size())
  , depthAt_(std::move(depthAt))
  , separates_(std::move(separates))
  , step_(step)
  , chains_(limits)
  , checkpoint_(checkpoint)
  , queue_(kBucketWidth)
{
}

void Thinning::anchor(const std::vector<CubeCell>& faces, FaceAngle angleOf)
{
  angleOf_ = std::move(angleOf);
  for (const CubeCell face : faces)
  {
    anchors_.insert(face);
  }
}

void Thinning::burn()
{
  for (const CubeCell voxel : cellsOf(complex_, kVoxelKind))
  {
    if (this->hasFreeFace(voxel))
    {
      this->raise(voxel);
    }
  }
  this->drain();
}

void Thinning::release(const std::vector<CubeCell>& faces)
{
  for (const CubeCell face : faces)
  {
    anchors_.erase(face);
  }
  for (const CubeCell face : faces)
  {
    this->raise(face);
  }
  this->drain();
}

/// Every maximal cell with a free face is in the queue, except those that are kept.
void Thinning::raise(CubeCell cell, int chain)
{
  if (!complex_.has(cell) || !complex_.maximal(cell))
  {
    return;
  }
  switch (CubicalComplex::dimension(CubicalComplex::kind(cell)))
  {
    case 3:
      if (!anchors_.has(cell))
      {
        anchors_.insert(cell);
        queue_.push(static_cast<double>(depthAt_(CubicalComplex::index(cell))), { cell, chain });
      }
      break;
    case 2:
      if (!anchors_.has(cell) && this->hasFreeFace(cell))
      {
        queue_.push(0.0, { cell, chain });
      }
      break;
    case 1:
      if (!anchors_.has(cell) && this->hasFreeFace(cell))
      {
        this->raiseEdge(cell, chain);
      }
      break;
    default:
      break;
  }
}

void Thinning::raiseEdge(CubeCell edge, int chain)
{
  if (chain == CurveChains::kNone && !separates_(edge))
  {
    queue_.push(0.0, { edge, kNoCurve });
    return;
  }
  queue_.push(chains_.arrival(chain, this->edgePosition(edge), this->depthAround(edge)),
    { edge, chain });
}

void Thinning::drain()
{
  constexpr unsigned kEventsPerCheck = 1024;
  unsigned events = 0;
  do
  {
    for (Event event{}; queue_.pop(event);)
    {
      if (++events % kEventsPerCheck == 0)
      {
        checkpoint_();
      }
      if (!complex_.has(event.cell) || !complex_.maximal(event.cell))
      {
        continue;
      }
      switch (CubicalComplex::dimension(CubicalComplex::kind(event.cell)))
      {
        case 3:
          this->burnVoxel(event.cell);
          break;
        case 2:
          this->burnFace(event.cell);
          break;
        default:
          this->burnEdge(event.cell, event.chain);
          break;
      }
    }
  } while (this->openGate());
}

void Thinning::burnVoxel(CubeCell voxel)
{
  anchors_.erase(voxel);
  const CubeCell face = this->freeFace(voxel, false);
  if (face >= 0)
  {
    this->collapse(voxel, face);
    return;
  }
  for (const CubeCell step : complex_.faces(kVoxelKind))
  {
    const CubeCell gate = voxel + step;
    if (complex_.onlyCoface(gate) == voxel)
    {
      gates_.emplace(angleOf_(gate), gate, voxel);
    }
  }
}

void Thinning::burnFace(CubeCell face)
{
  const CubeCell edge = anchors_.has(face) ? -1 : this->freeFace(face);
  if (edge >= 0)
  {
    this->collapse(face, edge);
  }
}

void Thinning::burnEdge(CubeCell edge, int chain)
{
  const CubeCell vertex = anchors_.has(edge) ? -1 : this->freeFace(edge);
  if (vertex < 0)
  {
    return;
  }
  if (chain == kNoCurve)
  {
    this->collapse(edge, vertex);
    return;
  }
  const glm::vec3 position = this->edgePosition(edge);
  const float depth = this->depthAround(edge);
  const CubeCellSteps& ends = complex_.faces(CubicalComplex::kind(edge));
  const CubeCell other = (edge + ends.steps[0]) + (edge + ends.steps[1]) - vertex;
  const bool goesOn = complex_.cofaceCount(other) == 2;
  std::vector<CurveChains::Pair> restored;
  // Where two balls touch, no edge separates patches. Without the curves that lead there, the balls
  // would be lost.
  if (!chains_.lasting(chain, position, depth, goesOn, restored) ||
    !(separates_(edge) || chains_.descends(chain, position, depth)))
  {
    this->collapse(edge, vertex,
      goesOn ? chains_.extend(chain, { edge, vertex }, position, depth) : CurveChains::kNone);
    return;
  }
  anchors_.insert(edge);
  for (const CurveChains::Pair& pair : restored)
  {
    complex_.insert(pair.edge);
    complex_.insert(pair.vertex);
    anchors_.insert(pair.edge);
  }
}

/// Lets the fire through the anchored face with the smallest angle that it has reached.
bool Thinning::openGate()
{
  while (!gates_.empty())
  {
    const auto [angle, gate, voxel] = gates_.top();
    gates_.pop();
    if (complex_.has(voxel) && complex_.has(gate) && anchors_.has(gate))
    {
      anchors_.erase(gate);
      this->raise(voxel);
      return true;
    }
  }
  return false;
}

void Thinning::collapse(CubeCell cell, CubeCell freeFace, int edgeChain)
{
  complex_.erase(cell);
  complex_.erase(freeFace);
  for (const CubeCell step : complex_.faces(CubicalComplex::kind(cell)))
  {
    const CubeCell face = cell + step;
    if (face == freeFace)
    {
      continue;
    }
    const CubeCell coface = complex_.onlyCoface(face);
    this->raise(coface >= 0 ? coface : face, edgeChain);
  }
  for (const CubeCell step : complex_.faces(CubicalComplex::kind(freeFace)))
  {
    const CubeCell coface = complex_.onlyCoface(freeFace + step);
    if (coface >= 0)
    {
      this->raise(coface);
    }
  }
}

bool Thinning::hasFreeFace(CubeCell cell) const
{
  const CubeCellSteps& faces = complex_.faces(CubicalComplex::kind(cell));
  return std::any_of(faces.begin(), faces.end(),
    [&](CubeCell step) { return complex_.onlyCoface(cell + step) == cell; });
}

/// Returns the free face of a maximal cell that lies least deep; -1 if there is none. This keeps
/// what is left near the middle of parts as thin as a voxel.
CubeCell Thinning::freeFace(CubeCell cell, bool anchoredToo) const
{
  std::array<CubeCell, 6> free{};
  int count = 0;
  for (const CubeCell step : complex_.faces(CubicalComplex::kind(cell)))
  {
    const CubeCell face = cell + step;
    if (complex_.onlyCoface(face) == cell && (anchoredToo || !anchors_.has(face)))
    {
      free[count++] = face;
    }
  }
  if (count < 2)
  {
    return count == 0 ? -1 : free[0];
  }
  return *std::min_element(free.begin(), free.begin() + count,
    [this](CubeCell a, CubeCell b) { return this->depthAround(a) < this->depthAround(b); });
}

glm::vec3 Thinning::edgePosition(CubeCell edge) const
{
  return glm::vec3(complex_.centre(edge) * step_);
}

/// Returns the mean depth of the voxels around a cell. Around an edge it is nearly that of the
/// curve next to it, minus a constant.
float Thinning::depthAround(CubeCell cell) const
{
  const unsigned spans = CubicalComplex::spans(CubicalComplex::kind(cell));
  float sum = 0.0f;
  int count = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
  {
    if ((corner & spans) == 0)
    {
      std::size_t voxel = CubicalComplex::index(cell);
      for (int axis = 0; axis < 3; ++axis)
      {
        voxel -= (corner >> axis & 1) != 0 ? static_cast<std::size_t>(complex_.stride(axis)) : 0;
      }
      sum += depthAt_(voxel);
      ++count;
    }
  }
  return sum / static_cast<float>(count);
}

} // namespace medial
