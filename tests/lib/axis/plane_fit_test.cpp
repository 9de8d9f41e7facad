#include "axis/plane_fit.h"

#include <gtest/gtest.h>

#include <cmath>

using medial::PlaneFit;

namespace
{

const glm::dvec3 kCentre(0.5);
const glm::dvec3 kReach(0.6);

void expectNear(const glm::dvec3& a, const glm::dvec3& b)
{
  EXPECT_LE(glm::distance(a, b), 1e-9);
}

} // namespace

TEST(PlaneFit, ThreePlanesMeetInACorner)
{
  PlaneFit fit;
  fit.add({ 0.3, 0.9, 0.1 }, { 1.0, 0.0, 0.0 }, 1.0);
  fit.add({ 0.0, 0.6, 0.7 }, { 0.0, 1.0, 0.0 }, 1.0);
  fit.add({ 0.8, 0.2, 0.4 }, { 0.0, 0.0, 1.0 }, 0.5);
  expectNear(fit.solve(kCentre, kReach), { 0.3, 0.6, 0.4 });
}

TEST(PlaneFit, TwoPlanesLeaveTheirLineToTheMean)
{
  PlaneFit fit;
  fit.add({ 0.3, 0.9, 0.2 }, { 1.0, 0.0, 0.0 }, 1.0);
  fit.add({ 0.0, 0.6, 0.8 }, { 0.0, 1.0, 0.0 }, 1.0);
  expectNear(fit.solve(kCentre, kReach), { 0.3, 0.6, 0.5 });
}

TEST(PlaneFit, SlidesAlongTheLineOfTwoPlanesIntoReach)
{
  // They meet in the line x = y = z; its point nearest to the mean is at 0.2.
  PlaneFit fit;
  fit.add({ 0.1, 0.1, 0.4 }, glm::normalize(glm::dvec3(1.0, -1.0, 0.0)), 1.0);
  fit.add({ 0.0, 0.3, 0.3 }, glm::normalize(glm::dvec3(0.0, 1.0, -1.0)), 1.0);
  expectNear(fit.solve(glm::dvec3(0.9), glm::dvec3(0.5)), glm::dvec3(0.4));
}

TEST(PlaneFit, NearlyParallelPlanesAreOneSheet)
{
  PlaneFit fit;
  fit.add({ 0.2, 0.1, 0.5 }, { 0.0, 0.0, 1.0 }, 1.0);
  const double tilt = 0.1;
  fit.add({ 0.8, 0.3, 0.5 }, { std::sin(tilt), 0.0, std::cos(tilt) }, 1.0);
  EXPECT_NEAR(fit.solve(kCentre, kReach).x, 0.5, 0.02);
}

TEST(PlaneFit, GivesUpWhatLiesOutOfReach)
{
  // The planes meet at x = 5.
  PlaneFit fit;
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.1, 0.0, 1.0));
  fit.add({ 0.0, 0.5, 0.5 }, { normal.z, 0.0, -normal.x }, 1e-9);
  fit.add({ 0.9, 0.5, 0.5 }, { 0.0, 0.0, 1.0 }, 1.0);
  fit.add({ 5.0, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, 1.0);
  const glm::dvec3 point = fit.solve(kCentre, kReach);
  EXPECT_NEAR(point.z, 0.5, 1e-6);
}

TEST(PlaneFit, StartsAnewAfterClear)
{
  PlaneFit fit;
  fit.add({ 9.0, 9.0, 9.0 }, { 1.0, 0.0, 0.0 }, 1.0);
  fit.clear();
  fit.add({ 0.5, 0.5, 0.5 }, { 1.0, 0.0, 0.0 }, 1.0);
  expectNear(fit.mean(), kCentre);
  expectNear(fit.solve(kCentre, kReach), kCentre);
}
