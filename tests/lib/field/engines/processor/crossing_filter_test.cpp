#include "field/engines/processor/crossing_filter.h"

#include "culling/candidate_filter.h"
#include "culling/group_tree.h"
#include "culling/site_query.h"
#include "field/engines/processor/tile_evaluator.h"
#include "sites/site_bounds.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace medial::test
{
namespace
{

/// The grid edges of a torus whose ends have different closest sites, and those that the axis
/// crosses, in double precision.
class FilteredCrossings : public testing::TestWithParam<double>
{
protected:
  struct Edge
  {
    glm::ivec3 voxel;
    int axis;
    int siteA;
    int siteB;
  };

  std::vector<Edge> edges() const
  {
    const SiteQuery query(filter_.tree());
    const auto site = [&](const glm::ivec3& voxel)
    { return query.closest(frame_.sample(glm::dvec3(voxel))).site; };
    std::vector<Edge> edges;
    for (int z = 0; z + 1 < grid_.dimensions[2]; ++z)
    {
      for (int y = 0; y + 1 < grid_.dimensions[1]; ++y)
      {
        for (int x = 0; x + 1 < grid_.dimensions[0]; ++x)
        {
          for (int axis = 0; axis < 3; ++axis)
          {
            glm::ivec3 end(x, y, z);
            ++end[axis];
            const int siteA = site({ x, y, z });
            const int siteB = site(end);
            if (siteA != siteB)
            {
              edges.push_back({ { x, y, z }, axis, siteA, siteB });
            }
          }
        }
      }
    }
    return edges;
  }

  bool isCrossed(const Edge& edge) const
  {
    const glm::dvec3 x = frame_.sample(glm::dvec3(edge.voxel));
    glm::dvec3 along(0.0);
    along[edge.axis] = frame_.step[edge.axis];
    const glm::dvec3 near = evaluator_.displacement(edge.siteA, x);
    const glm::dvec3 far = evaluator_.displacement(edge.siteB, x + along);
    const bool wide = glm::dot(near, far) <=
      std::cos(glm::radians(GetParam())) * glm::length(near) * glm::length(far);
    return wide && glm::length(along + far - near) >= glm::length(along);
  }

  TriangleMesh mesh_ = torus(1.0, 0.4, 24, 12);
  Grid grid_ = makeGrid(mesh_.bounds(), 32);
  GridFrame frame_{ grid_ };
  MeshConnectivity connectivity_ = analyseConnectivity(mesh_);
  SiteSet sites_{ mesh_, connectivity_, frame_ };
  CandidateFilter filter_{ sites_, connectivity_, frame_ };
  SiteBounds bounds_{ sites_, connectivity_ };
  std::vector<glm::vec4> noNormals_;
  TileEvaluator evaluator_{ sites_, bounds_, noNormals_, frame_, filter_.slack() };
};

TEST_P(FilteredCrossings, HoldAllThatAreCrossedAndFewMore)
{
  const CrossingFilter filter({ GetParam(), Side::Both }, sites_, frame_, filter_.slack());
  std::size_t crossed = 0;
  std::size_t left = 0;
  std::size_t all = 0;
  for (const Edge& edge : this->edges())
  {
    CrossingFilter::Edges edges{};
    const auto lane = all++ % kLanes; // the others are the first edge of site 0
    const glm::vec3 from(frame_.sample(glm::dvec3(edge.voxel)));
    for (int axis = 0; axis < 3; ++axis)
    {
      edges.from[axis][lane] = from[axis];
    }
    edges.axis[lane] = edge.axis;
    edges.siteA[lane] = edge.siteA;
    edges.siteB[lane] = edge.siteB;
    const bool may = (filter.mayBeCrossed(edges) >> lane & 1u) != 0;
    EXPECT_TRUE(may || !this->isCrossed(edge)) << edge.siteA << " " << edge.siteB;
    crossed += this->isCrossed(edge) ? 1 : 0;
    left += may ? 1 : 0;
  }
  EXPECT_GT(crossed, 50U);
  EXPECT_LT(left - crossed, (all - crossed) / 20);
}

INSTANTIATE_TEST_SUITE_P(Angles, FilteredCrossings, testing::Values(24.0, 60.0, 130.0));

} // namespace
} // namespace medial::test
