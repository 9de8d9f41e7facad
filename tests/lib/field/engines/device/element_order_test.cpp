#include "field/engines/device/element_order.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace medial::test
{
namespace
{

/// Elements of very different sizes, and some of every kind.
TEST(ElementOrder, HasEveryElementOnceAndGroupsOfOneSize)
{
  TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.0 }, { 0.4, 0.9, 0.1 },
                                 { 0.0, 0.5, 0.8 }, { 1.0, 0.5, 0.7 }, { 0.5, 0.1, 1.0 } },
    { { 0, 1, 2 } }, { { 3, 4 }, { 0, 1 } }, { 5, 2 });
  mesh = appended(mesh, scaled(mesh, 1000.0));
  mesh = appended(mesh, torus(1.0, 0.3, 16, 8));
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  const std::vector<std::int32_t> order = orderElements(mesh, connectivity);
  EXPECT_EQ(order.size() % kGroupSize, 0u);
  std::vector<std::int32_t> sites(order);
  sites.erase(std::remove(sites.begin(), sites.end(), -1), sites.end());
  std::sort(sites.begin(), sites.end());
  EXPECT_EQ(std::adjacent_find(sites.begin(), sites.end()), sites.end());
  // All faces, and of each of the two small meshes an edge and a vertex of no face.
  ASSERT_EQ(sites.size(), mesh.triangles.size() + 4);
  std::vector<std::int32_t> faces(mesh.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  EXPECT_TRUE(std::equal(faces.begin(), faces.end(), sites.begin()));
  EXPECT_GT(order.size(), sites.size());
}

} // namespace
} // namespace medial::test
