#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Distances of grid points on one side of a surface, rounded as radii of local thickness are, in
/// about a byte each: they differ little from what their neighbours in a row of the grid lead to.
class DepthRows
{
public:
  /// Adds a row.
  /// @param depths distances, units of the finest spacing; a point on the other side has none above
  ///   0.
  void add(const float* depths, std::size_t count);
  /// Frees memory that is held for more rows.
  void finish();

  /// Memory of the rows.
  std::size_t byteCount() const;
  /// Sets the depths of a row; those of points on the other side stay as they are.
  void read(std::size_t row, float* depths) const;

private:
  void addNumber(std::uint32_t number);

  std::vector<std::size_t> begins_; ///< of the rows
  /// For each stretch of points on the side: how many points before it are not, how many are, and
  /// their depths, as numbers of 7 bits a byte, the lowest first.
  std::vector<std::uint8_t> bytes_;
};

} // namespace medial
