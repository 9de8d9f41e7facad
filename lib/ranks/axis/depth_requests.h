#pragma once

#include "medial/ranks.h"
#include "ranks/field/grid_share.h"
#include "thinning/sparse_voxels.h"
#include "thinning/voxel_solid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace medial
{

/// Lets the first rank look at the voxels of a whole solid, whose depths the ranks have in pieces:
/// what it looks at is brought from where it is, and stays.
class DepthRequests
{
public:
  /// @param depth in a part of the grid that has all points of this rank's.
  /// @param part that one.
  DepthRequests(Communicator& communicator, const GridShare& share, const DepthField& depth,
    const Extent& part);

  /// Does work on the first rank, while the others answer. Every rank calls it.
  /// @param work work(voxels), on this thread.
  template <typename Work>
  void during(const Work& work)
  {
    if (communicator_.rank() == 0)
    {
      work(voxels_);
      this->answer({});
      return;
    }
    while (this->answer({}))
    {
    }
  }

private:
  bool answer(const std::vector<std::size_t>& blocks);
  template <typename Visit>
  void visitPoints(std::size_t block, const Extent& inner, const Extent& outer,
    const Visit& visit) const;

  Communicator& communicator_;
  const GridShare& share_;
  const DepthField& depth_;
  Extent part_;
  glm::ivec3 size_;
  SparseVoxels voxels_; ///< on the first rank
};

} // namespace medial
