#include "sites/closest_point.h"
#include "sites/grid_frame.h"
#include "sites/pseudonormals.h"
#include "sites/site_bounds.h"
#include "sites/site_set.h"

#include "support/brute_force.h"
#include "support/named.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Local units; half-spaces are stored in single precision.
constexpr double kPrecision = 1e-4;

/// A surface z = (x^2 - y^2) / 2 over a square, all of whose inner vertices are saddles.
TriangleMesh saddle()
{
  constexpr int kSide = 9;
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int j = 0; j < kSide; ++j)
  {
    for (int i = 0; i < kSide; ++i)
    {
      const double x = 0.25 * i - 1.0;
      const double y = 0.25 * j - 1.0;
      const int n = static_cast<int>(points.size());
      points.push_back({ x, y, 0.5 * (x * x - y * y) });
      if (i > 0 && j > 0)
      {
        triangles.push_back({ n - kSide - 1, n - kSide, n });
        triangles.push_back({ n - kSide - 1, n, n - 1 });
      }
    }
  }
  return makeMesh(points, triangles);
}

TriangleMesh trianglePointAndSegment()
{
  return makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.2, 0.4 }, { 0.5, 0.9, 0.3 }, { 0.2, 0.1, 0.9 } },
    { { 0, 1, 2 } }, { { 0, 3 } }, { 3 });
}

TriangleMesh manyFacedEdges()
{
  const TriangleMesh boxes =
    appended(box({ 0.5, 0.5, 0.5 }), translated(box({ 0.5, 0.5, 0.5 }), { 1.0, 1.0, 0.0 }));
  return appended(boxes, translated(box({ 0.5, 0.5, 0.5 }), { 1.0, 0.0, 0.0 }));
}

std::vector<Named<TriangleMesh>> meshes()
{
  return { { "box",
             [] {
               return box({ 1.0, 0.6, 0.3 });
             } },
    { "lPrism", [] { return lPrism(1.0, 0.5); } },
    { "torus", [] { return torus(1.0, 0.4, 12, 7); } }, { "saddle", saddle },
    { "manyFacedEdges", manyFacedEdges }, { "soup", [] { return randomSoup(40, 9); } },
    { "denseSoup", [] { return scaled(randomSoup(150, 10), 0.4); } },
    { "plates", [] { return plates(0.5, 1.0); } },
    { "sharpWedge", [] { return wedge(3.0, 1.0, 1.0); } },
    { "pointsAndSegments", trianglePointAndSegment } };
}

class SiteSetOf : public testing::TestWithParam<Named<TriangleMesh>>
{
protected:
  /// A site whose interior holds the point closest to x, among the faces, edges and vertices.
  int closestSite(const glm::dvec3& x) const
  {
    SitePoint best;
    double min = 1e300;
    for (int site = 0; site < sites_.size(); ++site)
    {
      const SitePoint candidate = closestPoint(sites_, site, x);
      if (glm::distance(candidate.point, x) < min)
      {
        min = glm::distance(candidate.point, x);
        best = candidate;
      }
    }
    return best.site;
  }

  /// How far x is outside the half-spaces of a site; negative inside all of them.
  double excess(int site, const glm::dvec3& x) const
  {
    double most = -1e300;
    bounds_.prepare(site);
    for (const HalfSpace* h = bounds_.begin(site); h != bounds_.end(site); ++h)
    {
      most = std::max(most, glm::dot(glm::dvec3(*h), x) - static_cast<double>(h->w));
    }
    return most;
  }

  const TriangleMesh mesh_ = GetParam().make();
  const MeshConnectivity connectivity_ = analyseConnectivity(mesh_);
  const Grid grid_ = makeGrid(mesh_.bounds(), 40, 0.6);
  const GridFrame frame_{ grid_ };
  const SiteSet sites_{ mesh_, connectivity_, frame_ };
  const SiteBounds bounds_{ sites_, connectivity_ };
  const std::vector<Point3> queries_ = randomPoints(
    { grid_.origin,
      grid_.point(grid_.dimensions[0] - 1, grid_.dimensions[1] - 1, grid_.dimensions[2] - 1) },
    4000, 17);
};

} // namespace

TEST_P(SiteSetOf, BoundsContainThePointsClosestToASite)
{
  std::vector<double> excesses(queries_.size());
  parallelFor(queries_.size(),
    [&](std::size_t i)
    {
      const glm::dvec3 x = frame_.toLocal(queries_[i]);
      excesses[i] = excess(closestSite(x), x);
    });
  EXPECT_LE(*std::max_element(excesses.begin(), excesses.end()), kPrecision);
}

TEST_P(SiteSetOf, ClosestPointsAreThoseOfTheOracle)
{
  for (std::size_t q = 0; q < 200; ++q)
  {
    const glm::dvec3 x = frame_.toLocal(queries_[q]);
    for (int site = 0; site < sites_.size(); ++site)
    {
      const double truth = distanceToSite(mesh_, connectivity_, site, queries_[q]) / frame_.unit;
      ASSERT_NEAR(glm::distance(closestPoint(sites_, site, x).point, x), truth, 1e-9);
    }
  }
}

TEST_P(SiteSetOf, SpheresContainTheirSites)
{
  for (int face = 0; face < sites_.faceCount(); ++face)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::dvec4 sphere(sites_.boundingBall(face));
      const glm::dvec3& p = sites_.points()[sites_.faces()[face][corner]];
      EXPECT_LE(glm::distance(glm::dvec3(sphere), p), sphere.w + kPrecision);
    }
  }
}

TEST_P(SiteSetOf, NumbersFacesEdgesAndVerticesInThisOrder)
{
  EXPECT_EQ(sites_.faceCount(), static_cast<int>(mesh_.triangles.size()));
  EXPECT_EQ(sites_.edgeCount(), static_cast<int>(connectivity_.edges.size()));
  EXPECT_EQ(sites_.vertexCount(), static_cast<int>(mesh_.points.size()));
  EXPECT_EQ(sites_.kind(sites_.firstEdge()), SiteKind::Edge);
  EXPECT_EQ(sites_.kind(sites_.firstVertex() - 1), SiteKind::Edge);
  EXPECT_EQ(sites_.kind(sites_.firstVertex()), SiteKind::Vertex);
}

INSTANTIATE_TEST_SUITE_P(Meshes, SiteSetOf, testing::ValuesIn(meshes()), kNameOfParameter);

TEST(SiteSet, ShortEdgesStandForTrianglesWithoutArea)
{
  const TriangleMesh mesh =
    makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.1, 0.3 }, { 0.5, 0.05, 0.15 }, { 0.0, 1.0, 0.0 } },
      { { 0, 1, 2 }, { 0, 1, 3 } });
  const SiteSet sites(mesh, analyseConnectivity(mesh), GridFrame(makeGrid(mesh.bounds(), 16, 0.1)));
  EXPECT_FALSE(sites.active(0));
  EXPECT_TRUE(sites.active(1));
  const glm::ivec3& edges = sites.faceEdges()[0];
  EXPECT_EQ(sites.longestEdge(0), 0);
  EXPECT_FALSE(sites.active(sites.firstEdge() + edges[0]));
  EXPECT_TRUE(sites.active(sites.firstEdge() + edges[1]));
  EXPECT_TRUE(sites.active(sites.firstEdge() + edges[2]));
}

/// Each of two triangles could leave another of two equal edges out, and each edge of a ring.
TEST(SiteSet, OneOfTiedLongestEdgesStays)
{
  const TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 0.0, 1e-13, 0.0 }, { 1.0, 0.0, 0.0 } },
    { { 0, 1, 2 }, { 2, 0, 1 } });
  const SiteSet sites(mesh, analyseConnectivity(mesh), GridFrame(makeGrid(mesh.bounds(), 16, 0.1)));
  int active = 0;
  for (int edge = 0; edge < sites.edgeCount(); ++edge)
  {
    active += sites.active(sites.firstEdge() + edge) ? 1 : 0;
  }
  EXPECT_EQ(active, 2);
}

TEST(SiteSet, EdgesWhoseEndsAreOnePointAreNotActive)
{
  const TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 0.0, 1e-17, 0.0 }, { 1.0, 1.0, 0.0 } },
    {}, { { 0, 1 }, { 1, 2 } });
  const SiteSet sites(mesh, analyseConnectivity(mesh), GridFrame(makeGrid(mesh.bounds(), 16, 0.1)));
  EXPECT_FALSE(sites.active(sites.firstEdge()));
  EXPECT_TRUE(sites.active(sites.firstEdge() + 1));
  EXPECT_EQ(closestPoint(sites, sites.firstEdge(), glm::dvec3(0.0)).point, sites.points()[0]);
}

/// Every edge here belongs to several triangles without area, so a search along edges has very many
/// ways to go.
TEST(Pseudonormals, AreQuickForPilesOfTrianglesWithoutArea)
{
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < 40; ++i)
  {
    triangles.push_back({ 0, 1, 2 });
    triangles.push_back({ 1, 2, 3 });
  }
  triangles.push_back({ 0, 3, 4 });
  const TriangleMesh mesh = makeMesh({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 },
                                       { 3.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } },
    triangles);
  const SiteSet sites(mesh, analyseConnectivity(mesh), GridFrame(makeGrid(mesh.bounds(), 16, 0.1)));
  const std::vector<glm::vec4> normals = pseudonormals(sites, false);
  EXPECT_EQ(normals.size(), static_cast<std::size_t>(sites.size()));
  EXPECT_EQ(normals[0], glm::vec4(0.0f));
  EXPECT_EQ(glm::abs(normals[80].z), 1.0f);
}

TEST(SiteSet, FramesAreCentredOnTheGridInUnitsOfItsFinestSpacing)
{
  const Grid grid{ { 1e6, -3.0, 2.0 }, { 0.5, 0.25, 1.0 }, { 11, 21, 5 } };
  const GridFrame frame(grid);
  EXPECT_EQ(frame.unit, 0.25);
  EXPECT_EQ(frame.step, glm::dvec3(2.0, 1.0, 4.0));
  EXPECT_EQ(frame.sample(glm::dvec3(5.0, 10.0, 2.0)), glm::dvec3(0.0));
  const glm::dvec3 corner = frame.toLocal(grid.point(10, 20, 4));
  EXPECT_EQ(corner, frame.sample(glm::dvec3(10.0, 20.0, 4.0)));
  EXPECT_EQ(frame.toWorld(corner), grid.point(10, 20, 4));
}
