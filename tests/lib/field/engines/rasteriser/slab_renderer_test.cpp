#include "culling/candidate_filter.h"
#include "field/engines/rasteriser/hole_repair.h"
#include "field/engines/rasteriser/rectangle_source.h"
#include "field/engines/rasteriser/slab_readback.h"
#include "field/engines/rasteriser/slab_renderer.h"
#include "gl/gpu_thread.h"
#include "medial/compute_distance_field.h"
#include "medial/error.h"
#include "sites/pseudonormals.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace medial::test
{
namespace
{

Extent extentOf(int x, int y, int z)
{
  return { { 0, 0, 0 }, { x - 1, y - 1, z - 1 } };
}

TEST(AtlasLayout, HoldsASlabAndTheSliceBefore)
{
  const AtlasLayout atlas = AtlasLayout::make(extentOf(100, 50, 200), 64, 1000);
  EXPECT_GE(atlas.columns * atlas.rows, 65);
  EXPECT_LE(atlas.size().x, 1000);
  EXPECT_LE(atlas.size().y, 1000);
}

TEST(AtlasLayout, TakesNoMoreSlicesThanTheExtentHas)
{
  const AtlasLayout atlas = AtlasLayout::make(extentOf(100, 50, 3), 64, 16384);
  EXPECT_LE(atlas.columns * atlas.rows, 5);
}

TEST(AtlasLayout, SlicesThatDoNotFitAreRefused)
{
  EXPECT_TRUE(AtlasLayout::fits(extentOf(600, 600, 10), 1, 1200));
  EXPECT_FALSE(AtlasLayout::fits(extentOf(600, 600, 10), 4, 1200));
  EXPECT_THROW(AtlasLayout::make(extentOf(600, 600, 10), 4, 1200), Error);
}

class NoRectangles : public RectangleSource
{
public:
  int next(const gl::Buffer& /*rectangles*/, int /*room*/) override { return 0; }
};

/// A torus on a small grid, with everything that must precede drawing.
class SlabOfTorus : public testing::Test
{
protected:
  TriangleMesh mesh_ = torus(1.0, 0.4, 16, 8);
  MeshConnectivity connectivity_ = analyseConnectivity(mesh_);
  Grid grid_ = makeGrid(mesh_.bounds(), 100);
  GridFrame frame_{ grid_ };
  SiteSet sites_{ mesh_, connectivity_, frame_ };
  Extent slab_ = grid_.wholeExtent();
  CandidateFilter filter_{ sites_, connectivity_, frame_ };
};

/// Whether a site is nearest at a grid point, is for brute force to say.
TEST_F(SlabOfTorus, RectanglesHoldEveryClosestSiteInAscendingOrder)
{
  const AtlasLayout atlas = AtlasLayout::make(slab_, 64, 4096);
  gl::OnGpuThread<SlabRenderer> renderer(mesh_, connectivity_, atlas);
  constexpr int kRoom = 100; // so that layers come in several parts
  std::vector<SiteRectangle> rectangles;
  renderer.run(
    [&](SlabRenderer& r)
    {
      r.move(mesh_, {}, frame_);
      r.cull(slab_);
      const gl::Buffer buffer = gl::createStorageBuffer(kRoom * sizeof(SiteRectangle), nullptr);
      while (const int count = r.rectangles().next(buffer, kRoom))
      {
        const std::size_t before = rectangles.size();
        rectangles.resize(before + count);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetNamedBufferSubData(buffer.id(), 0,
          static_cast<GLsizeiptr>(count * sizeof(SiteRectangle)), &rectangles[before]);
      }
    });
  ASSERT_GT(rectangles.size(), 2u * kRoom);
  std::map<std::pair<int, int>, std::vector<SiteRectangle>> ofSites; // by layer of tiles and site
  for (std::size_t i = 0; i < rectangles.size(); ++i)
  {
    const SiteRectangle& b = rectangles[i];
    const SiteRectangle& a = rectangles[i > 0 ? i - 1 : 0];
    EXPECT_TRUE(a.low.z < b.low.z || (a.low.z == b.low.z && a.site <= b.site));
    EXPECT_LT(b.high.x - b.low.x, 64);
    EXPECT_LT(b.high.y - b.low.y, 64);
    EXPECT_EQ(b.low.z % 8, 0);
    EXPECT_EQ(b.high.z, std::min(b.low.z + 7, slab_.max[2]));
    ofSites[{ b.low.z / 8, b.site }].push_back(b);
  }
  const SiteQuery query(filter_.tree());
  for (int i = 0; i < 2000; ++i)
  {
    const glm::ivec3 point(i * 37 % slab_.size(0), i * 53 % slab_.size(1), i * 11 % slab_.size(2));
    const int site = query.closest(frame_.sample(glm::dvec3(point))).site;
    const std::vector<SiteRectangle>& found = ofSites[{ point.z / 8, site }];
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
      [&](const SiteRectangle& r)
      {
        return glm::all(glm::lessThanEqual(r.low, point)) &&
          glm::all(glm::lessThanEqual(point, r.high));
      }))
      << site << " at " << point.x << ' ' << point.y << ' ' << point.z;
  }
}

TEST_F(SlabOfTorus, HolesAreFilledExactly)
{
  const auto normals = pseudonormals(sites_, false);
  const SiteQuery query(filter_.tree());
  const auto count = static_cast<std::size_t>(slab_.pointCount());
  std::vector<glm::vec4> filled(count);
  gl::OnGpuThread<SlabRenderer> renderer(mesh_, connectivity_, AtlasLayout::make(slab_, 64, 4096));
  renderer.run(
    [&](SlabRenderer& r)
    {
      r.move(mesh_, normals, frame_);
      NoRectangles none; // and no polygon: every grid point is a hole
      r.draw(none, slab_);
      EXPECT_EQ(r.resolve(slab_), count);
      repairHoles(r, normals, frame_, query, slab_);
      r.readDisplacements(slab_.size(2), filled.data());
    });
  const DistanceField truth = computeDistanceField(mesh_, grid_);
  double worst = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double distance = static_cast<double>(filled[i].w) * frame_.unit;
    worst = std::max(worst, std::abs(distance - static_cast<double>(truth.distance[i])));
  }
  EXPECT_LT(worst, 1e-3 * frame_.unit);
}

using SlabOfTorusDeathTest = SlabOfTorus;

/// In a process of its own, since OpenGL's debug output fails a test.
TEST_F(SlabOfTorusDeathTest, AFailedReadBackLeavesNoPixelBufferBound)
{
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  const auto readBack = [&]
  {
    const AtlasLayout atlas = AtlasLayout::make(slab_, 64, 4096);
    gl::OnGpuThread<SlabRenderer> renderer(mesh_, connectivity_, atlas);
    gl::OnGpuThread<SlabReadback> tooSmall(atlas, 1, true, true);
    GLint bound = -1;
    bool refused = false;
    renderer.run(
      [&](SlabRenderer& r)
      {
        try
        {
          tooSmall.object().fetch(r, 2);
        }
        catch (const Error& error)
        {
          refused = error.code() == ErrorCode::GpuLimit;
        }
        glGetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &bound);
      });
    return refused && bound == 0;
  };
  EXPECT_EXIT(std::exit(readBack() ? 0 : 1), testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace medial::test
