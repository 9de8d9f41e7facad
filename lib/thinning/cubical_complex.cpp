#include "thinning/cubical_complex.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cstring>
#include <limits>

namespace medial
{
namespace
{

/// Returns the kind of cells that extend along the axes of a span.
int kindOfSpan(unsigned span)
{
  int kind = 0;
  while (CubicalComplex::spans(kind) != span)
  {
    ++kind;
  }
  return kind;
}

void add(CubeCellSteps& steps, CubeCell step)
{
  steps.steps[steps.count++] = step;
}

/// Inserts a face with its edges and corners.
void insertClosed(CubeCell face, CubicalComplex& complex)
{
  complex.insert(face);
  for (const CubeCell step : complex.faces(CubicalComplex::kind(face)))
  {
    const CubeCell edge = face + step;
    complex.insert(edge);
    for (const CubeCell end : complex.faces(CubicalComplex::kind(edge)))
    {
      complex.insert(edge + end);
    }
  }
}

} // namespace

CubicalComplex::CubicalComplex(const glm::ivec3& size)
  : CubicalComplex({ { 0, 0, 0 }, { size.x - 1, size.y - 1, size.z - 1 } }, size)
{
}

CubicalComplex::CubicalComplex(const Extent& part, const glm::ivec3& grid)
  : size_(part.size(0), part.size(1), part.size(2))
  , grid_(grid)
  , first_(part.min[0], part.min[1], part.min[2])
  , stride_{ 1, size_.x, static_cast<std::int64_t>(size_.x) * size_.y }
  , start_(first_.x + stride_[1] * first_.y + stride_[2] * first_.z)
  , positions_(static_cast<std::size_t>(stride_[2]) * size_.z)
  , blocks_(blocksFor(positions_))
{
  for (int kind = 0; kind < kCubeCellKinds; ++kind)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const unsigned along = 1u << axis;
      const CubeCell step = 8 * stride_[axis];
      const CubeCell other = kindOfSpan(kSpans[kind] ^ along) - kind;
      CubeCellSteps& steps = (kSpans[kind] & along) != 0 ? faces_[kind] : cofaces_[kind];
      add(steps, other);
      add(steps, &steps == &faces_[kind] ? other + step : other - step);
    }
  }
}

void CubicalComplex::insert(const CubicalComplex& other)
{
  for (std::size_t i = 0; i < blocks_.count(); ++i)
  {
    if (other.blocks_.has(i))
    {
      const Block& theirs = other.blocks_[i];
      Block& block = blocks_.make(i);
      std::transform(block.begin(), block.end(), theirs.begin(), block.begin(),
        [](std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a | b); });
    }
  }
}

void CubicalComplex::copyBits(std::size_t first, std::size_t count, std::uint8_t* bits) const
{
  for (std::size_t done = 0; done < count;)
  {
    const std::size_t begin = (first + done) % kBlockLength;
    const std::size_t together = std::min(kBlockLength - begin, count - done);
    const Block& block = blocks_[(first + done) / kBlockLength];
    std::copy_n(block.begin() + static_cast<std::ptrdiff_t>(begin), together, bits + done);
    done += together;
  }
}

glm::ivec3 CubicalComplex::position(CubeCell cell) const
{
  const std::size_t p = index(cell);
  const auto split = [this](auto place)
  {
    using Place = decltype(place);
    const auto row = place / static_cast<Place>(size_.x);
    const auto z = row / static_cast<Place>(size_.y);
    return glm::ivec3(static_cast<int>(place - row * static_cast<Place>(size_.x)),
      static_cast<int>(row - z * static_cast<Place>(size_.y)), static_cast<int>(z));
  };
  // Short divisions take a fraction of the time of long ones.
  return first_ +
    (this->positions() <= std::numeric_limits<std::uint32_t>::max()
        ? split(static_cast<std::uint32_t>(p))
        : split(p));
}

glm::dvec3 CubicalComplex::centre(CubeCell cell) const
{
  glm::dvec3 centre(this->position(cell));
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis] -= (kSpans[kind(cell)] >> axis & 1) != 0 ? 0.0 : 0.5;
  }
  return centre;
}

std::array<CubeCell, 12> facesAround(const CubicalComplex& complex, CubeCell vertex)
{
  std::array<CubeCell, 12> faces{};
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const CubeCell u = 8 * complex.stride((axis + 1) % 3);
    const CubeCell v = 8 * complex.stride((axis + 2) % 3);
    const CubeCell face = vertex + kFaceKind + axis;
    for (const CubeCell step : { CubeCell{ 0 }, u, v, u + v })
    {
      faces[count++] = face - step;
    }
  }
  return faces;
}

std::array<glm::ivec3, 8> voxelsAround(const CubicalComplex& complex, CubeCell vertex)
{
  std::array<glm::ivec3, 8> voxels{};
  for (int corner = 0; corner < 8; ++corner)
  {
    voxels[corner] =
      complex.position(vertex) - glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
  }
  return voxels;
}

CubicalComplex closureOf(const glm::ivec3& size, const std::vector<CubeCell>& faces)
{
  constexpr int kLayers = 4;
  CubicalComplex complex(size);
  const auto firstAbove = [&](int z)
  { return std::lower_bound(faces.begin(), faces.end(), 8 * complex.stride(2) * z); };
  for (const CubeCell face : faces)
  {
    const int axis = CubicalComplex::kind(face) - kFaceKind;
    const std::size_t corner = CubicalComplex::index(face);
    const auto u = static_cast<std::size_t>(complex.stride((axis + 1) % 3));
    const auto v = static_cast<std::size_t>(complex.stride((axis + 2) % 3));
    for (const std::size_t step : { std::size_t{ 0 }, u, v, u + v })
    {
      complex.makeRoom(corner + step);
    }
  }
  // The faces of some layers have cells in the next one as well: every other block at a time.
  const int blocks = (size.z + kLayers - 1) / kLayers;
  for (const int odd : { 0, 1 })
  {
    tbb::parallel_for(0, (blocks + 1 - odd) / 2,
      [&](int pair)
      {
        const int low = kLayers * (2 * pair + odd);
        std::for_each(firstAbove(low), firstAbove(low + kLayers),
          [&](CubeCell face) { insertClosed(face, complex); });
      });
  }
  return complex;
}

void insertVoxels(const std::vector<std::size_t>& voxels, CubicalComplex& complex)
{
  std::array<std::size_t, kVoxelCells.size()> steps{};
  for (std::size_t corner = 0; corner < steps.size(); ++corner)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      steps[corner] +=
        (corner >> axis & 1) * static_cast<std::size_t>(complex.stride(static_cast<int>(axis)));
    }
  }
  for (const std::size_t voxel : voxels)
  {
    for (std::size_t corner = 0; corner < steps.size(); ++corner)
    {
      complex.insert(voxel + steps[corner], kVoxelCells[corner]);
    }
  }
}

std::vector<CubeCell> cellsOf(const CubicalComplex& complex, int kind)
{
  constexpr std::size_t kTogether = 1024; // blocks
  const std::uint64_t ofKind = std::uint64_t{ 0x0101010101010101 } << kind;
  const SparseBlocks<CubicalComplex::Block>& blocks = complex.blocks();
  const std::size_t parts = (blocks.count() + kTogether - 1) / kTogether;
  std::vector<std::vector<CubeCell>> found(parts);
  const auto add = [&](std::size_t block, std::vector<CubeCell>& cells)
  {
    const CubicalComplex::Block& bits = blocks[block];
    std::uint64_t eight = 0;
    for (std::size_t first = 0; first < bits.size(); first += sizeof(eight))
    {
      std::memcpy(&eight, bits.data() + first, sizeof(eight));
      for (std::size_t i = first; (eight & ofKind) != 0 && i < first + sizeof(eight); ++i)
      {
        if ((bits[i] >> kind & 1) != 0)
        {
          cells.push_back(8 * static_cast<CubeCell>(block * kBlockLength + i) + kind);
        }
      }
    }
  };
  tbb::parallel_for(std::size_t{ 0 }, parts,
    [&](std::size_t part)
    {
      const std::size_t end = std::min(blocks.count(), (part + 1) * kTogether);
      for (std::size_t block = part * kTogether; block < end; ++block)
      {
        if (blocks.has(block))
        {
          add(block, found[part]);
        }
      }
    });
  std::vector<CubeCell> cells;
  for (const std::vector<CubeCell>& each : found)
  {
    cells.insert(cells.end(), each.begin(), each.end());
  }
  return cells;
}

} // namespace medial
