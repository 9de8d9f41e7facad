#include "proximity/closest_element.h"

#include "support/shapes.h"
#include "support/transforms.h"
#include "support/uneven_meshes.h"

#include "proximity/element_distance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace medial::test
{
namespace
{

/// By all elements; of equally near ones the first.
ClosestElement closestOfAll(const MovingMesh& mesh, const glm::dvec3& x)
{
  ClosestElement best;
  for (int element = 0; element < mesh.size(); ++element)
  {
    const int slot = mesh.slotOf(element);
    const glm::dvec3 point = closestPoint(mesh.element(slot), x);
    const double squared = glm::dot(point - x, point - x);
    if (squared < best.squared)
    {
      best = { squared, point, slot };
    }
  }
  return best;
}

/// Positions around one, near or far.
void checkSearches(const TriangleMesh& shape, std::uint32_t seed)
{
  const MovingMesh mesh(shape);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const Box& box = mesh.tree().box();
  const double size = glm::length(box.size());
  const auto vector = [&](double length)
  { return length * glm::dvec3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 200; ++i)
  {
    const int count = 1 + i % kDoubleLanes;
    const glm::dvec3 middle = 0.5 * (box.min + box.max) + vector(0.2 * size);
    const double apart = i % 5 == 0 ? size : 0.02 * size;
    std::array<glm::dvec3, kDoubleLanes> positions{};
    std::array<ClosestElement, kDoubleLanes> found;
    for (int k = 0; k < count; ++k)
    {
      positions[k] = middle + vector(apart);
      found[k].slot = i % 3 == 0 ? -1 : static_cast<int>(random() % mesh.size());
    }
    closestElements(mesh, positions.data(), count, found.data());
    for (int k = 0; k < count; ++k)
    {
      const ClosestElement expected = closestOfAll(mesh, positions[k]);
      const double tolerance = 1e-12 * size * size;
      EXPECT_NEAR(found[k].squared, expected.squared, tolerance);
      EXPECT_EQ(found[k].squared, closestElement(mesh, positions[k]).squared);
      EXPECT_EQ(found[k].point, closestElement(mesh, positions[k]).point);
      EXPECT_EQ(found[k].slot, closestElement(mesh, positions[k]).slot);
    }
  }
}

TEST(ClosestElements, AreThoseOfSingleSearches)
{
  checkSearches(icosphere(1.0, 2), 1);
  checkSearches(roughSphere(1.0, 2, 0.3), 2);
  checkSearches(translated(roughSphere(1.0, 2, 0.3), { 3.0, 0.0, 0.0 }), 3);
  checkSearches(scaled(box({ 1.0, 0.6, 0.3 }), 1e-60), 4);
}

TEST(ClosestElements, OfElementsWithoutAreaAreThoseOfSingleSearches)
{
  TriangleMesh needles = roughSphere(1.0, 2, 0.3);
  for (Point3& point : needles.points)
  {
    point[1] *= 1e-9;
    point[2] *= 1e-5;
  }
  checkSearches(needles, 5);
  TriangleMesh flat = needles;
  for (Point3& point : flat.points)
  {
    point[1] = point[2] = 0.0;
  }
  checkSearches(flat, 6);
}

} // namespace
} // namespace medial::test
