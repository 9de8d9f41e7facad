#pragma once

#include "base/huge_pages.h"
#include "medial/grid.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

/// Differences between cube cells of one kind and their faces or their cofaces.
struct CubeCellSteps
{
  int count = 0;
  std::array<CubeCell, 6> steps{};

  const CubeCell* begin() const { return steps.data(); }
  const CubeCell* end() const { return steps.data() + count; }
};

/// A cubical complex: unit cubes around grid points ("voxels") with their square faces, edges and
/// corners. It stores which of these cube cells are there, in one byte per grid point. (Voxel
/// Cores, Yan, Letscher, Ju 2018, thin the dual complex in the same way.)
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
  std::size_t positions() const { return bits_.size(); }
  CubeCell cell(const glm::ivec3& position, int kind) const
  {
    return 8 * (position.x + stride_[1] * position.y + stride_[2] * position.z - start_) + kind;
  }
  glm::ivec3 position(CubeCell cell) const;
  /// Returns the centre of a cell, in indices of grid points.
  glm::dvec3 centre(CubeCell cell) const;

  bool has(CubeCell cell) const { return (bits_[index(cell)] >> kind(cell) & 1) != 0; }
  void insert(CubeCell cell) { bits_[index(cell)] |= static_cast<std::uint8_t>(1u << kind(cell)); }
  /// Inserts the cells of a complex of the same size.
  void insert(const CubicalComplex& other);
  void erase(CubeCell cell)
  {
    bits_[index(cell)] &= static_cast<std::uint8_t>(~(1u << kind(cell)));
  }

  /// The cells at a position: bit k for kind k.
  std::uint8_t bits(std::size_t position) const { return bits_[position]; }
  /// The same for the positions from one on.
  const std::uint8_t* bitsFrom(std::size_t position) const { return bits_.data() + position; }
  std::uint8_t* bitsFrom(std::size_t position) { return bits_.data() + position; }

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
  ZeroedVector<std::uint8_t> bits_;
};

/// The cells at eight positions in a row, to be looked at together.
struct EightCells
{
  static constexpr std::size_t kCount = 8;

  std::uint64_t word = 0;

  /// @param count of them that are there; the others are empty.
  static EightCells load(const std::uint8_t* bits, std::size_t count = kCount)
  {
    EightCells cells;
    std::memcpy(&cells.word, bits, count);
    return cells;
  }
  /// The same cells at all of them.
  static constexpr EightCells filled(std::uint8_t bits)
  {
    return { std::uint64_t{ 0x0101010101010101 } * bits };
  }
};

/// Returns the cells of a kind, ascending.
std::vector<CubeCell> cellsOf(const CubicalComplex& complex, int kind);

/// Returns the faces around a vertex, whether they are there or not: those dual to the edges of its
/// grid cell.
std::array<CubeCell, 12> facesAround(const CubicalComplex& complex, CubeCell vertex);

/// Returns a complex of faces, with their edges and corners.
/// @param faces ascending by their positions.
CubicalComplex closureOf(const glm::ivec3& size, const std::vector<CubeCell>& faces);

/// Numbers the cells of a list, so that one is found at once: a bit for each cell of a complex, and
/// the number of those before each 64. Takes 1.5 bytes for each position.
class CellRanks
{
public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  explicit CellRanks(const CubicalComplex& complex)
    : cells_((complex.positions() + kTogether - 1) / kTogether)
    , before_(cells_.size())
  {
  }

  /// @param cellOf returns the cell of an item of the list, ascending and distinct.
  template <typename Item, typename CellOf>
  void set(const std::vector<Item>& items, const CellOf& cellOf)
  {
    for (const CubeCell word : words_)
    {
      cells_[word] = 0;
    }
    words_.clear();
    for (std::size_t i = 0; i < items.size(); ++i)
    {
      const CubeCell cell = cellOf(items[i]);
      const CubeCell word = cell >> 6;
      if (words_.empty() || words_.back() != word)
      {
        words_.push_back(word);
        before_[word] = static_cast<std::uint32_t>(i);
      }
      cells_[word] |= std::uint64_t{ 1 } << (cell & 63);
    }
  }

  /// Returns the index of the item of a cell, or kNone.
  std::size_t find(CubeCell cell) const
  {
    const std::uint64_t here = cells_[cell >> 6];
    const std::uint64_t bit = std::uint64_t{ 1 } << (cell & 63);
    return (here & bit) == 0
      ? kNone
      : before_[cell >> 6] + static_cast<std::size_t>(__builtin_popcountll(here & (bit - 1)));
  }

private:
  static constexpr std::size_t kTogether = 64 / kCubeCellKinds; ///< positions in one word

  ZeroedVector<std::uint64_t> cells_;
  ZeroedVector<std::uint32_t> before_; ///< where there are cells
  std::vector<CubeCell> words_;        ///< those of cells_ that are not 0
};

} // namespace medial
