// Sizes that cannot be tried: what is refused, and that nothing else overflows.
#include "base/id_limits.h"

#include "medial/error.h"

#include "support/errors.h"

#include <gtest/gtest.h>

#include <string>

using namespace medial;

namespace
{

std::string refusalOf(std::int64_t count, std::int64_t max = kMaxIds)
{
  return test::messageOf([&] { requireCount("the mesh", count, "sites", max); });
}

} // namespace

TEST(IdLimits, MoreIsRefusedWithTheFigure)
{
  EXPECT_EQ(refusalOf(0), "");
  EXPECT_EQ(refusalOf(2147483647), "");
  EXPECT_EQ(refusalOf(2147483648), "the mesh has 2147483648 sites, more than 2147483647");
  EXPECT_EQ(refusalOf(kMaxCorners, kMaxCorners), "");
  EXPECT_EQ(refusalOf(std::int64_t{ 1 } << 40, kMaxCorners),
    "the mesh has 1099511627776 sites, more than 536870911");
}

/// A polygon of n corners becomes n - 2 triangles with 2 n - 3 edges.
TEST(IdLimits, TheLargestMeshHasIdsForAllItsParts)
{
  constexpr std::int64_t kTriangles = kMaxCorners - 2;
  constexpr std::int64_t kEdges = 2 * kMaxCorners - 3;
  EXPECT_EQ(refusalOf(kTriangles + kEdges + kMaxCorners), ""); // sites
  EXPECT_EQ(refusalOf(3 * kTriangles), "");                    // sides
  EXPECT_EQ(refusalOf(2 * kEdges), "");                        // ends of edges
  EXPECT_EQ(refusalOf(4 * kMaxCrossings), "");                 // points of the dual mesh
}
