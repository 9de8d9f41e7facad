#pragma once

#include "medial/mesh_connectivity.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include "support/brute_force.h"
#include "support/culling_cases.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace medial::test
{

/// A test of the sites of a mesh and the points of a grid.
class CullingTest : public testing::TestWithParam<CullingCase>
{
protected:
  /// Returns random positions.
  /// @param indices of the grid, not only of its points, and beyond it.
  std::vector<glm::dvec3> randomPositions(const Bounds& indices, int count,
    std::uint32_t seed) const
  {
    std::vector<glm::dvec3> positions;
    for (const auto& [i, j, k] : randomPoints(indices, count, seed))
    {
      positions.push_back(frame_.sample({ i, j, k }));
    }
    return positions;
  }

  const TriangleMesh& mesh_ = GetParam().mesh;
  const Grid& grid_ = GetParam().grid;
  const GridFrame frame_{ grid_ };
  const MeshConnectivity connectivity_ = analyseConnectivity(mesh_);
  const SiteSet sites_{ mesh_, connectivity_, frame_ };
};

} // namespace medial::test
