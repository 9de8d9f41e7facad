#pragma once

#include "medial/grid.h"
#include "thinning/sparse_blocks.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// A cube cell, that is a cell of a cubical complex: 8 * linear index of its position +
/// kind.
using CubeCell = std::int64_t;

/// Kinds of cube cells: a vertex, edges along x, y, z, faces normal to x, y, z, a voxel.
constexpr int kVertexKind = 0;
constexpr int kEdgeKind = 1;
constexpr int kFaceKind = 4;
constexpr int kVoxelKind = 7;
constexpr int kCubeCellKinds = 8;

/// The cells of a voxel at its lowest corner, then at the corners beside that along x, y, z, a bit
/// for each kind.
constexpr std::array<std::uint8_t, 8> kVoxelCells{ 0xff, 0x1d, 0x2b, 0x09, 0x47, 0x05, 0x03, 0x01 };

/// Differences between cube cells of one kind and their faces or their cofaces.
struct CubeCellSteps
{
  int count = 0;
  std::array<CubeCell, 6> steps{};

  const CubeCell* begin() const { return steps.data(); }
  const CubeCell* end() const { return steps.data() + count; }
};

/// A cubical complex: unit cubes around grid points ("voxels") with their square faces, edges and
/// corners. It stores which of these cube cells are there, in one byte per grid point, for blocks
/// of points where there are some. (Voxel Cores, Yan, Letscher, Ju 2018, thin the dual complex in
/// the same way.)
///
/// Position p = (i, j, k), x fastest, has the voxel around grid point p, the voxel's three faces
/// and three edges that meet in its lowest corner, and that corner. So the face of normal axis a at
/// p is dual to the grid edge from p - e_a to p, and the vertex at p to the grid cell from p -
/// (1,1,1) to p. Only cells of voxels away from the border of the complex may be set.
///
/// A complex may have a part of a grid only. Positions are those of the grid all the same.
class CubicalComplex
{
public:
  explicit CubicalComplex(const glm::ivec3& size);
  /// @param part of the grid that has cells.
  /// @param grid grid points along each axis.
  CubicalComplex(const Extent& part, const glm::ivec3& grid);

  static int kind(CubeCell cell) { return static_cast<int>(cell & 7); }
  static int dimension(int kind) { return kind == kVertexKind ? 0 : (kind + 2) / 3; }
  /// Bit a is set if cells of a kind extend along axis a.
  static unsigned spans(int kind) { return kSpans[kind]; }
  static std::size_t index(CubeCell cell) { return static_cast<std::size_t>(cell >> 3); }

  const glm::ivec3& size() const { return size_; }
  /// Size of the grid of which this has a part, or all.
  const glm::ivec3& grid() const { return grid_; }
  /// Whether a position is in the part.
  bool covers(const glm::ivec3& position) const
  {
    const glm::ivec3 p = position - first_;
    return p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size_.x && p.y < size_.y && p.z < size_.z;
  }
  std::size_t positions() const { return positions_; }
  CubeCell cell(const glm::ivec3& position, int kind) const
  {
    return 8 * (position.x + stride_[1] * position.y + stride_[2] * position.z - start_) + kind;
  }
  glm::ivec3 position(CubeCell cell) const;
  /// Returns the centre of a cell, in indices of grid points.
  glm::dvec3 centre(CubeCell cell) const;

  bool has(CubeCell cell) const { return (this->bits(index(cell)) >> kind(cell) & 1) != 0; }
  void insert(CubeCell cell)
  {
    this->insert(index(cell), static_cast<std::uint8_t>(1u << kind(cell)));
  }
  /// Inserts cells at a position: bit k for kind k.
  void insert(std::size_t position, std::uint8_t bits)
  {
    blocks_.make(position / kBlockLength)[position % kBlockLength] |= bits;
  }
  /// Inserts the cells of a complex of the same size.
  void insert(const CubicalComplex& other);
  void erase(CubeCell cell)
  {
    if (this->has(cell))
    {
      blocks_.make(index(cell) / kBlockLength)[index(cell) % kBlockLength] &=
        static_cast<std::uint8_t>(~(1u << kind(cell)));
    }
  }
  /// Takes memory for the cells at a position, so that any thread may insert some there.
  void makeRoom(std::size_t position) { blocks_.make(position / kBlockLength); }

  /// The cells at a position: bit k for kind k.
  std::uint8_t bits(std::size_t position) const
  {
    return blocks_[position / kBlockLength][position % kBlockLength];
  }
  /// Copies the same for the positions from one on.
  void copyBits(std::size_t first, std::size_t count, std::uint8_t* bits) const;

  using Block = std::array<std::uint8_t, kBlockLength>;
  /// The cells at positions in a row, by the blocks of these.
  const SparseBlocks<Block>& blocks() const { return blocks_; }

  const CubeCellSteps& faces(int kind) const { return faces_[kind]; }
  const CubeCellSteps& cofaces(int kind) const { return cofaces_[kind]; }

  int cofaceCount(CubeCell cell) const
  {
    int count = 0;
    for (const CubeCell step : cofaces_[kind(cell)])
    {
      count += this->has(cell + step) ? 1 : 0;
    }
    return count;
  }
  bool maximal(CubeCell cell) const { return this->cofaceCount(cell) == 0; }
  /// Returns the only coface of a cell; -1 if there is none or more than one.
  CubeCell onlyCoface(CubeCell cell) const
  {
    CubeCell only = -1;
    for (const CubeCell step : cofaces_[kind(cell)])
    {
      if (this->has(cell + step))
      {
        if (only >= 0)
        {
          return -1;
        }
        only = cell + step;
      }
    }
    return only;
  }

  /// Linear step of positions along an axis.
  std::int64_t stride(int axis) const { return stride_[axis]; }

private:
  static constexpr std::array<unsigned, kCubeCellKinds> kSpans{ 0, 1, 2, 4, 6, 5, 3, 7 };

  glm::ivec3 size_;
  glm::ivec3 grid_;
  glm::ivec3 first_; ///< position of the part's lowest corner
  std::array<std::int64_t, 3> stride_;
  std::int64_t start_; ///< what the index of that position would be if the part began at 0
  std::array<CubeCellSteps, kCubeCellKinds> faces_;
  std::array<CubeCellSteps, kCubeCellKinds> cofaces_;
  std::size_t positions_;
  SparseBlocks<Block> blocks_;
};

/// Returns the cells of a kind, ascending.
std::vector<CubeCell> cellsOf(const CubicalComplex& complex, int kind);

/// Returns the faces around a vertex, whether they are there or not: those dual to the edges of its
/// grid cell.
std::array<CubeCell, 12> facesAround(const CubicalComplex& complex, CubeCell vertex);

/// Returns the positions of the voxels around a vertex, whether they are there or not: the corners
/// of its grid cell.
std::array<glm::ivec3, 8> voxelsAround(const CubicalComplex& complex, CubeCell vertex);

/// Returns a complex of faces, with their edges and corners.
/// @param faces ascending by their positions.
CubicalComplex closureOf(const glm::ivec3& size, const std::vector<CubeCell>& faces);

/// Inserts closed voxels, with all their faces, edges and corners.
/// @param voxels their positions.
void insertVoxels(const std::vector<std::size_t>& voxels, CubicalComplex& complex);

/// Numbers the cells of a list, so that one is found at once: a bit for each cell, and the number
/// of those before each 64, in the blocks of a complex where there are some.
class CellRanks
{
public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  explicit CellRanks(const CubicalComplex& complex)
    : blocks_(blocksFor(complex.positions()))
  {
  }

  /// @param cellOf returns the cell of an item of the list, ascending and distinct.
  template <typename Item, typename CellOf>
  void set(const std::vector<Item>& items, const CellOf& cellOf)
  {
    for (const std::size_t word : words_)
    {
      blocks_.make(word / kWords).cells[word % kWords] = 0;
    }
    words_.clear();
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const CubeCell cell = cellOf(items[i]);
      const std::size_t word = wordOf(cell);
      Block& block = blocks_.make(word / kWords);
      if (words_.empty() || words_.back() != word)
      {
        words_.push_back(word);
        block.before[word % kWords] = static_cast<std::uint32_t>(i);
      }
      block.cells[word % kWords] |= std::uint64_t{ 1 } << (cell & 63);
    }
  }

  /// Returns the index of the item of a cell, or kNone.
  std::size_t find(CubeCell cell) const
  {
    const std::size_t word = wordOf(cell);
    const Block& block = blocks_[word / kWords];
    const std::uint64_t here = block.cells[word % kWords];
    const std::uint64_t bit = std::uint64_t{ 1 } << (cell & 63);
    return (here & bit) == 0 ? kNone
                             : block.before[word % kWords] +
        static_cast<std::size_t>(__builtin_popcountll(here & (bit - 1)));
  }

private:
  static constexpr std::size_t kWords = kBlockLength * kCubeCellKinds / 64;
  struct Block
  {
    std::array<std::uint64_t, kWords> cells{};
    std::array<std::uint32_t, kWords> before{}; ///< where there are cells
  };

  static std::size_t wordOf(CubeCell cell) { return static_cast<std::size_t>(cell >> 6); }

  SparseBlocks<Block> blocks_;
  std::vector<std::size_t> words_; ///< those with cells
};

} // namespace medial
