#pragma once

#include "field/engines/device/device_mesh.h"
#include "field/engines/device/element_search.h"
#include "field/engines/device/inside_bits.h"
#include "field/engines/device/kernels.h"
#include "medial/grid.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace medial
{

/// Exact distances and closest sites of a slab, in buffers of the device. GPU thread only.
class SlabValues
{
public:
  /// @param mesh, search, inside, kernels must outlive this.
  SlabValues(const DeviceMesh& mesh, const ElementSearch& search, const InsideBits& inside,
    Kernels& kernels);

  /// Whether vectors to the closest points are wanted, besides distances.
  void setVectors(bool wanted) { wantsVectors_ = wanted; }
  /// Uploads pseudonormals, which give distances their sign; empty if they do not.
  void setNormals(const std::vector<glm::vec4>& normals);

  /// Keeps the sites of the last slice of a slab, as those below the next one.
  void carryLastSlice(const Extent& slab);
  /// Resolves what the search has found.
  void resolve(const GridFrame& frame, const Extent& slab);

  /// Distances, local units; after them vectors, if they are wanted.
  const gl::Buffer& values() const { return values_; }
  /// Closest sites, after those of the slice below.
  const gl::Buffer& sites() const { return sites_; }
  ///@{
  /// What sides.glsl tells the sides of grid points by.
  int sidesBy() const;
  const gl::Buffer& sides() const;
  ///@}

private:
  const DeviceMesh& mesh_;
  const ElementSearch& search_;
  const InsideBits& inside_;
  Kernels& kernels_;
  bool wantsVectors_ = false;
  bool hasNormals_ = false;
  gl::Buffer values_, sites_, normals_;
};

} // namespace medial
