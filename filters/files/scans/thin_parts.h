#pragma once

#include <array>

namespace medial::files
{

/// Finds parts of a label that are one voxel wide, and gaps of that width in it. A filter that
/// smooths steps would take them for steps and flatten them until they vanish.
///
/// A voxel is thin if it lies in no 2 x 2 x 2 voxels of its kind. Steps have thin voxels as well,
/// but these lie on wide ones. So a thin part has a thin voxel that shares no face with a wide one
/// of its kind, and the thin voxels around it belong to it.
class ThinParts
{
public:
  using Voxel = std::array<int, 3>;

  /// @param mask must outlive this: not 0 inside, x fastest. What is around it is outside.
  ThinParts(const unsigned char* mask, const std::array<int, 3>& size);

  /// Whether a voxel, inside or outside, belongs to a thin part or gap.
  bool contains(const Voxel& voxel) const;

private:
  bool isInside(const Voxel& voxel) const;
  bool isThin(const Voxel& voxel) const;
  /// Whether a voxel is thin and lies on no wide one.
  bool isAlone(const Voxel& voxel) const;

  const unsigned char* mask_;
  std::array<int, 3> size_;
};

} // namespace medial::files
