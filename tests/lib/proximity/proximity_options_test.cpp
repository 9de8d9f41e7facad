#include "medial/error.h"
#include "medial/proximity.h"

#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using medial::computeProximity;
using medial::Proximity;
using medial::ProximityOptions;
using medial::TriangleMesh;
using medial::test::box;
using medial::test::translated;

TEST(ProximityOptions, LeaveOutWhatIsNotAskedFor)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  ProximityOptions options;
  options.separation = false;
  options.depths = false;
  const Proximity apart = computeProximity(cube, translated(cube, { 3.0, 0.0, 0.0 }), options);
  EXPECT_FALSE(apart.collide);
  EXPECT_TRUE(std::isnan(apart.separation));
  EXPECT_EQ(apart.depth, 0.0);
  for (const TriangleMesh& other :
    { translated(cube, { 1.5, 0.0, 0.0 }), box({ 0.5, 0.5, 0.5 }), box({ 3.0, 3.0, 3.0 }) })
  {
    const Proximity result = computeProximity(cube, other, options);
    EXPECT_TRUE(result.collide);
    EXPECT_TRUE(std::isnan(result.depth));
    EXPECT_TRUE(std::isinf(result.translationalDepth.upper));
    EXPECT_TRUE(result.contacts.empty());
  }
}

TEST(ProximityOptions, MaxSeparationLeavesOutFarPairs)
{
  const TriangleMesh cube = box({ 1.0, 1.0, 1.0 });
  const TriangleMesh other = translated(cube, { 4.0, 0.0, 0.0 });
  ProximityOptions options;
  options.maxSeparation = 1.9;
  EXPECT_TRUE(std::isinf(computeProximity(cube, other, options).separation));
  options.maxSeparation = 2.1;
  EXPECT_NEAR(computeProximity(cube, other, options).separation, 2.0, 1e-12);
  options.maxSeparation = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(computeProximity(cube, other, options), medial::Error);
}

} // namespace
