// What OpenGL leaves of rectangles, against the half-spaces that are to cut them.
#include "culling/candidate_filter.h"
#include "field/engines/rasteriser/slab_renderer.h"
#include "gl/gpu_thread.h"
#include "support/shapes.h"
#include "support/transforms.h"
#include "support/uneven_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

/// Rectangles of a list in host memory, fewer than there is room for.
class ListedRectangles : public RectangleSource
{
public:
  explicit ListedRectangles(const std::vector<SiteRectangle>& list)
    : list_(list)
  {
  }

  int next(const gl::Buffer& rectangles, int room) override
  {
    const auto count = static_cast<int>(list_.size());
    EXPECT_LE(count, room);
    const bool first = !std::exchange(listed_, true);
    if (first && count > 0)
    {
      glNamedBufferSubData(rectangles.id(), 0,
        static_cast<GLsizeiptr>(list_.size() * sizeof(SiteRectangle)), list_.data());
    }
    return first ? count : 0;
  }

private:
  const std::vector<SiteRectangle>& list_;
  bool listed_ = false;
};

/// Single sites of a mesh, drawn over a whole grid.
class DrawnSites
{
public:
  DrawnSites(const TriangleMesh& mesh, const Grid& grid)
    : mesh_(mesh)
    , connectivity_(analyseConnectivity(mesh_))
    , frame_(grid)
    , sites_(mesh_, connectivity_, frame_)
    , bounds_(sites_, connectivity_)
    , extent_(grid.wholeExtent())
    , renderer_(mesh_, connectivity_, AtlasLayout::make(extent_, extent_.size(2), 4096))
  {
    renderer_.run([&](SlabRenderer& renderer) { renderer.move(mesh_, {}, frame_); });
  }

  const SiteSet& sites() const { return sites_; }
  int halfSpaceCount(int site) const
  {
    bounds_.prepare(site);
    return static_cast<int>(bounds_.end(site) - bounds_.begin(site));
  }

  /// Draws a site, and expects the grid points inside its half-spaces: all of these, and none that
  /// is outside more of them than there may be beyond OpenGL's eight, nor any beyond the ends of an
  /// edge.
  /// @return the number of grid points drawn.
  int expectRegionOf(int site)
  {
    const int count = this->halfSpaceCount(site);
    const int spare = std::max(count - 8, 0);
    const int ends = sites_.kind(site) == SiteKind::Edge ? 2 : 0;
    const std::vector<bool> drawn = this->draw(site);
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
      const glm::ivec3 point = this->pointOf(i);
      if (this->outside(site, count, point, -kMargin) == 0)
      {
        EXPECT_TRUE(drawn[i]) << "site " << site << " at " << point.x << ' ' << point.y << ' '
                              << point.z;
      }
      if (this->outside(site, count, point, kMargin) > spare ||
        this->outside(site, ends, point, kMargin) > 0)
      {
        EXPECT_FALSE(drawn[i]) << "site " << site << " at " << point.x << ' ' << point.y << ' '
                               << point.z;
      }
    }
    return static_cast<int>(std::count(drawn.begin(), drawn.end(), true));
  }

private:
  /// More than polygons overlap, in voxels.
  static constexpr double kMargin = 0.02;

  std::vector<bool> draw(int site)
  {
    constexpr int kSlices = 8;
    std::vector<SiteRectangle> rectangles;
    for (int z = 0; z < extent_.size(2); z += kSlices)
    {
      rectangles.push_back({ site, { 0, 0, z },
        { extent_.max[0], extent_.max[1], std::min(z + kSlices - 1, extent_.max[2]) } });
    }
    std::vector<std::int32_t> closest(static_cast<std::size_t>(extent_.pointCount()));
    renderer_.run(
      [&](SlabRenderer& renderer)
      {
        ListedRectangles source(rectangles);
        renderer.draw(source, extent_);
        renderer.resolve(extent_);
        renderer.readSites(extent_.size(2), closest.data());
      });
    std::vector<bool> drawn(closest.size());
    std::transform(closest.begin(), closest.end(), drawn.begin(),
      [](std::int32_t found) { return found >= 0; });
    return drawn;
  }

  glm::ivec3 pointOf(std::size_t i) const
  {
    const auto number = static_cast<int>(i);
    const int row = number / extent_.size(0);
    return { number % extent_.size(0), row % extent_.size(1), row / extent_.size(1) };
  }

  /// Returns how many of the first half-spaces the point is outside, by more than a margin.
  int outside(int site, int count, const glm::ivec3& point, double margin) const
  {
    const glm::dvec3 x = frame_.sample(glm::dvec3(point));
    return static_cast<int>(std::count_if(bounds_.begin(site), bounds_.begin(site) + count,
      [&](const HalfSpace& h)
      { return glm::dot(glm::dvec3(h), x) - static_cast<double>(h.w) > margin; }));
  }

  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
  GridFrame frame_;
  SiteSet sites_;
  SiteBounds bounds_;
  Extent extent_;
  gl::OnGpuThread<SlabRenderer> renderer_;
};

Grid cube(int points)
{
  const double first = -0.5 * (points - 1);
  return { { first, first, first }, { 1.0, 1.0, 1.0 }, { points, points, points } };
}

/// An open cone about the z axis, its apex up; the apex is the last point.
TriangleMesh cone(int edges, double radius, double height)
{
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < edges; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / edges;
    points.push_back({ radius * std::cos(angle), radius * std::sin(angle), -height });
    triangles.push_back({ i, (i + 1) % edges, edges });
  }
  points.push_back({ 0.13, 0.07, 0.21 });
  return makeMesh(points, triangles);
}

TEST(PolygonDrawing, CutsAllKindsOfSitesAtTheirHalfSpaces)
{
  DrawnSites drawn(torus(15.0, 6.0, 16, 8), cube(50));
  int points = 0;
  for (int site = 0; site < drawn.sites().size(); site += 7)
  {
    points += drawn.expectRegionOf(site);
  }
  EXPECT_GT(points, 10000);
}

TEST(PolygonDrawing, CutsVerticesWithMoreHalfSpacesThanOpenGlHasClipDistances)
{
  for (const int edges : { 3, 8, 9, 24, 300 })
  {
    DrawnSites drawn(cone(edges, 14.0, 12.0), cube(40));
    const int apex = drawn.sites().size() - 1;
    EXPECT_EQ(drawn.halfSpaceCount(apex), edges);
    const int points = drawn.expectRegionOf(apex);
    // The region of a vertex is the cone above it; those that are left may not leave much more.
    EXPECT_GT(points, 1000) << edges << " edges";
    EXPECT_LT(points, 10000) << edges << " edges";
  }
}

TEST(PolygonDrawing, KeepsTheEndsOfEdgesWithVeryManyFaces)
{
  std::vector<Point3> points = { { -5.3, 0.2, -7.1 }, { 4.1, -0.4, 8.2 } };
  std::vector<std::array<int, 3>> triangles;
  constexpr int kFaces = 20;
  for (int i = 0; i < kFaces; ++i)
  {
    const double angle = 0.1 * i; // all on one side
    points.push_back({ 12.0 * std::cos(angle), 12.0 * std::sin(angle), 0.0 });
    triangles.push_back({ 0, 1, 2 + i });
  }
  DrawnSites drawn(makeMesh(points, triangles), cube(40));
  const int edge = drawn.sites().firstEdge();
  const glm::ivec2 ends = drawn.sites().edges()[0];
  ASSERT_EQ(std::max(ends.x, ends.y), 1);
  EXPECT_EQ(drawn.halfSpaceCount(edge), 2 + kFaces);
  EXPECT_GT(drawn.expectRegionOf(edge), 1000);
}

TEST(PolygonDrawing, CutsSliversWithoutReachingBeyondTheirCorners)
{
  // No needle is just as high as faces that are sites must be: positions on the device are rounded.
  DrawnSites drawn(appended(scaled(needleFan(14, 30.0), 1.01), twistedStrip(4, 22.0, 0.02)),
    cube(40));
  for (int site = 0; site < drawn.sites().size(); ++site)
  {
    if (drawn.sites().active(site))
    {
      drawn.expectRegionOf(site);
    }
  }
}

/// Beyond the corners of this one the margins of its long sides hold grid points of a slice.
TEST(PolygonDrawing, CutsASliverAlongGridPointsAtItsCorners)
{
  DrawnSites drawn(
    makeMesh({ { -9.5, 0.0, 0.0 }, { 9.5, 0.0, 0.0 }, { 0.3, 0.0, 4e-4 } }, { { 0, 1, 2 } }),
    cube(41));
  ASSERT_TRUE(drawn.sites().active(0));
  EXPECT_GT(drawn.expectRegionOf(0), 19);
}

} // namespace
} // namespace medial::test
