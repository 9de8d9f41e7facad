#include "medial/medial/topology/cell_lattice.h"

namespace medial
{
namespace
{

/// The kind of cells that extend along the axes of a span.
int kindOfSpan(unsigned span)
{
  int kind = 0;
  while (CellLattice::spans(kind) != span)
  {
    ++kind;
  }
  return kind;
}

void add(CellSteps& steps, Cell step)
{
  steps.steps[steps.count++] = step;
}

} // namespace

CellLattice::CellLattice(const glm::ivec3& size)
  : size_(size)
  , stride_{ 1, size.x, static_cast<std::int64_t>(size.x) * size.y }
  , bits_(static_cast<std::size_t>(stride_[2]) * size.z, std::uint8_t{ 0 })
{
  for (int kind = 0; kind < kCellKinds; ++kind)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const unsigned along = 1u << axis;
      const Cell step = 8 * stride_[axis];
      const Cell other = kindOfSpan(kSpans[kind] ^ along) - kind;
      CellSteps& steps = (kSpans[kind] & along) != 0 ? faces_[kind] : cofaces_[kind];
      add(steps, other);
      add(steps, &steps == &faces_[kind] ? other + step : other - step);
    }
  }
}

glm::ivec3 CellLattice::position(Cell cell) const
{
  const auto p = static_cast<std::int64_t>(index(cell));
  return { static_cast<int>(p % stride_[1]), static_cast<int>(p / stride_[1] % size_.y),
    static_cast<int>(p / stride_[2]) };
}

glm::dvec3 CellLattice::centre(Cell cell) const
{
  glm::dvec3 centre(this->position(cell));
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis] -= (kSpans[kind(cell)] >> axis & 1) != 0 ? 0.0 : 0.5;
  }
  return centre;
}

} // namespace medial
