#include "skeleton/solid_probe.h"

#include "base/run.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/tubes.h"

#include <gtest/gtest.h>

#include <vector>

namespace medial::test
{
namespace
{

/// A mesh and questions about it, in world coordinates.
class Asked
{
public:
  explicit Asked(const TriangleMesh& mesh)
    : query_(mesh, SignMethod::Winding, Run{ Execution{} }, {})
  {
  }

  glm::dvec3 at(double x, double y, double z) const
  {
    return query_.local().toLocal(Point3{ x, y, z });
  }
  double unit() const { return query_.local().unit; }
  double wayOut(const glm::dvec3& from, const glm::dvec3& direction, double high) const
  {
    return probe_.wayOut(from, direction, high / this->unit()) * this->unit();
  }
  const SolidProbe& probe() const { return probe_; }

private:
  DistanceQuery query_;
  SolidProbe probe_{ query_ };
};

} // namespace

TEST(SolidProbe, FindsTheWayOutOfABox)
{
  const Asked asked(box({ 2.0, 1.0, 0.5 }));
  const glm::dvec3 from = asked.at(0.3, 0.1, 0.2);
  constexpr double kHigh = 5.0;
  const double tolerance = 1e-4;
  EXPECT_NEAR(asked.wayOut(from, { 1.0, 0.0, 0.0 }, kHigh), 1.7, tolerance);
  EXPECT_NEAR(asked.wayOut(from, { -1.0, 0.0, 0.0 }, kHigh), 2.3, tolerance);
  EXPECT_NEAR(asked.wayOut(from, { 0.0, 0.0, 1.0 }, kHigh), 0.3, tolerance);
  EXPECT_NEAR(asked.wayOut(from, { 0.6, 0.0, 0.8 }, kHigh), 0.3 / 0.8, tolerance);
  EXPECT_DOUBLE_EQ(asked.wayOut(from, { 1.0, 0.0, 0.0 }, 1.5), 1.5); // no farther than that
}

TEST(SolidProbe, LeavesTheSolidThroughNarrowGaps)
{
  const TriangleMesh block = box({ 2.0, 1.0, 0.5 });
  for (const double gap : { 0.5, 0.02, 0.0003 })
  {
    SCOPED_TRACE(gap);
    const TriangleMesh blocks = appended(block, translated(block, { 4.0 + gap, 0.0, 0.0 }));
    const Asked asked(blocks);
    for (const double y : { 0.0, 0.9 })
    {
      EXPECT_NEAR(asked.wayOut(asked.at(0.3, y, 0.2), { 1.0, 0.0, 0.0 }, 5.0), 1.7, 1e-4);
      EXPECT_NEAR(asked.wayOut(asked.at(2.3 + gap, y, 0.2), { -1.0, 0.0, 0.0 }, 2.0), 0.3, 1e-4);
    }
  }
}

TEST(SolidProbe, LeavesAnOpenTubeThroughItsEnds)
{
  // No surface is there, so the distance to it does not tell how far it is to the outside.
  const Asked asked(openTube(0.3, 4.0, 64));
  EXPECT_NEAR(asked.wayOut(asked.at(0.0, 0.0, 0.0), { 0.0, 0.0, 1.0 }, 5.0), 2.0, 1e-3);
  EXPECT_NEAR(asked.wayOut(asked.at(0.0, 0.0, 1.9), { 0.0, 0.0, 1.0 }, 0.7), 0.1, 1e-3);
}

TEST(SolidProbe, RadiiAlongACurveAreThoseOfItsPoints)
{
  const Asked asked(box({ 2.0, 1.0, 0.5 }));
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 200; ++i)
  {
    points.push_back(asked.at(-1.9 + 0.019 * i, 0.3, 0.1));
  }
  const std::vector<double> radii = asked.probe().radii(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_EQ(radii[i], asked.probe().radius(points[i])) << i;
  }
}

TEST(SolidProbe, FindsTheWidestPlaceAsPreciselyAsItIsAskedTo)
{
  const Asked asked(box({ 0.3, 0.3, 2.0 }));
  for (const double precision : { 0.01, 0.001 })
  {
    SolidProbe::Search search = asked.probe().search();
    const glm::dvec3 found = SolidProbe::widestAcross(search, asked.at(0.06, -0.03, 0.5),
      { 0.0, 0.0, 1.0 }, precision / asked.unit());
    EXPECT_LT(glm::distance(found, asked.at(0.0, 0.0, 0.5)) * asked.unit(), 2.0 * precision);
  }
}

} // namespace medial::test
