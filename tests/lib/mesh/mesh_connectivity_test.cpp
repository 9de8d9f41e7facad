#include "medial/error.h"
#include "medial/mesh_connectivity.h"
#include "support/errors.h"
#include "support/models.h"
#include "support/shapes.h"

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using namespace medial;
using namespace medial::test;

namespace
{

/// V - E + F
int eulerCharacteristic(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  return static_cast<int>(mesh.points.size()) - static_cast<int>(connectivity.edges.size()) +
    static_cast<int>(mesh.triangles.size());
}

/// The lists agree with the triangles and segments, whatever the mesh.
void expectConsistent(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  std::set<std::pair<int, int>> pairs;
  for (const auto& edge : connectivity.edges)
  {
    EXPECT_TRUE(pairs.insert(std::minmax(edge[0], edge[1])).second) << "an edge is there twice";
  }
  std::size_t incidences = 0;
  ASSERT_EQ(connectivity.triangleEdges.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int edge = connectivity.triangleEdges[i][corner];
      const int a = mesh.triangles[i][corner];
      const int b = mesh.triangles[i][(corner + 1) % 3];
      EXPECT_EQ(std::minmax(connectivity.edges[edge][0], connectivity.edges[edge][1]),
        std::minmax(a, b));
      const int* const end = connectivity.edgeTriangles.end(edge);
      EXPECT_NE(std::find(connectivity.edgeTriangles.begin(edge), end, static_cast<int>(i)), end);
      ++incidences;
    }
  }
  EXPECT_EQ(connectivity.edgeTriangles.values.size(), incidences);
  EXPECT_EQ(connectivity.edgeTriangles.rows(), static_cast<int>(connectivity.edges.size()));
  EXPECT_EQ(connectivity.pointEdges.rows(), static_cast<int>(mesh.points.size()));
  EXPECT_EQ(connectivity.pointEdges.values.size(), 2 * connectivity.edges.size());
  for (int point = 0; point < connectivity.pointEdges.rows(); ++point)
  {
    for (const int* edge = connectivity.pointEdges.begin(point);
         edge != connectivity.pointEdges.end(point); ++edge)
    {
      EXPECT_TRUE(connectivity.edges[*edge][0] == point || connectivity.edges[*edge][1] == point);
    }
  }
}

MeshConnectivity analysed(const TriangleMesh& mesh)
{
  MeshConnectivity connectivity = analyseConnectivity(mesh);
  expectConsistent(mesh, connectivity);
  return connectivity;
}

/// `count` triangles around the edge between points 0 and 1.
TriangleMesh fins(int count)
{
  std::vector<Point3> points = { { 0, 0, 0 }, { 0, 0, 1 } };
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < count; ++i)
  {
    points.push_back({ std::cos(i), std::sin(i), 0.5 });
    triangles.push_back({ 0, 1, i + 2 });
  }
  return makeMesh(points, triangles);
}

TriangleMesh moebiusStrip(int segments)
{
  const double step = 2.0 * std::acos(-1.0) / segments;
  std::vector<Point3> points;
  std::vector<std::array<int, 3>> triangles;
  for (int i = 0; i < segments; ++i)
  {
    for (const double side : { -0.3, 0.3 })
    {
      const double rho = 1.0 + side * std::cos(0.5 * i * step);
      points.push_back(
        { rho * std::cos(i * step), rho * std::sin(i * step), side * std::sin(0.5 * i * step) });
    }
    const bool last = i + 1 == segments;
    const int next = last ? 1 : 2 * i + 2;
    const int nextOther = last ? 0 : 2 * i + 3;
    triangles.insert(triangles.end(),
      { { 2 * i, next, 2 * i + 1 }, { 2 * i + 1, next, nextOther } });
  }
  return makeMesh(points, triangles);
}

/// The number of triangles that a half-edge mesh of OpenMesh refuses when they are added in their
/// order.
int refusedTriangles(const TriangleMesh& mesh)
{
  omerr().disable();
  OpenMesh::TriConnectivity halfEdges;
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    halfEdges.new_vertex();
  }
  return static_cast<int>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
    [&](const std::array<int, 3>& t)
    {
      return !halfEdges
                .add_face(halfEdges.vertex_handle(t[0]), halfEdges.vertex_handle(t[1]),
                  halfEdges.vertex_handle(t[2]))
                .is_valid();
    }));
}

/// A double cone over a rim; its triangles are given in a random order.
TriangleMesh doubleCone(int rim)
{
  TriangleMesh mesh;
  mesh.points = { { 0, 0, 1 }, { 0, 0, -1 } };
  for (int i = 0; i < rim; ++i)
  {
    const double angle = 2.0 * std::acos(-1.0) * i / rim;
    mesh.points.push_back({ std::cos(angle), std::sin(angle), 0.0 });
    const int next = (i + 1) % rim;
    mesh.triangles.push_back({ 0, 2 + i, 2 + next });
    mesh.triangles.push_back({ 1, 2 + next, 2 + i });
  }
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), std::mt19937(3));
  mesh.triangleCells.resize(mesh.triangles.size());
  return mesh;
}

struct Figures
{
  const char* model;
  int components;
  int boundaryEdges;
  int nonManifoldEdges;
  int euler;
};

} // namespace

TEST(MeshConnectivity, Tetrahedron)
{
  const TriangleMesh mesh = regularTetrahedron(2.0);
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_EQ(connectivity.edges.size(), 6u);
  EXPECT_EQ(connectivity.components, 1);
  EXPECT_TRUE(connectivity.closed() && connectivity.manifold() && connectivity.oriented());
  EXPECT_EQ(connectivity.edgeTriangles.size(0), 2);
  EXPECT_EQ(connectivity.pointEdges.size(3), 3);
  EXPECT_NEAR(connectivity.signedVolume, std::sqrt(8.0) / 3.0, 1e-12);
}

TEST(MeshConnectivity, GeneratedShapesAreClosedAndOutward)
{
  const std::vector<TriangleMesh> shapes = { box({ 1, 2, 3 }), lPrism(1, 2), icosphere(2, 2),
    ellipsoid(3, 2, 1, 2), uvCapsule(1, 2, 16), uvCapsule(1, 0, 12), torus(3, 1, 20, 10),
    cylinder(1, 4, 17), shell(1, 2, 2), wedge(40, 5, 2), wedge(300, 5, 2), regularTetrahedron(1),
    mirrored(lPrism(1, 1), 0), rotated90(lPrism(1, 1), 2) };
  const std::vector<int> euler = { 2, 2, 2, 2, 2, 2, 0, 2, 4, 2, 2, 2, 2, 2 };
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    const MeshConnectivity connectivity = analysed(shapes[i]);
    EXPECT_TRUE(connectivity.closed() && connectivity.manifold() && connectivity.oriented())
      << "shape " << i;
    EXPECT_GT(connectivity.signedVolume, 0.0) << "shape " << i;
    EXPECT_EQ(eulerCharacteristic(shapes[i], connectivity), euler[i]) << "shape " << i;
  }
}

TEST(MeshConnectivity, VolumesOfGeneratedShapes)
{
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(analyseConnectivity(lPrism(1, 2)).signedVolume, 12.0, 1e-12);
  EXPECT_NEAR(analyseConnectivity(icosphere(1, 5)).signedVolume, 4.0 / 3.0 * pi, 4e-3);
  EXPECT_NEAR(analyseConnectivity(torus(3, 1, 200, 100)).signedVolume, 6.0 * pi * pi, 0.1);
  EXPECT_NEAR(analyseConnectivity(cylinder(1, 4, 500)).signedVolume, 4.0 * pi, 1e-3);
  EXPECT_NEAR(analyseConnectivity(uvCapsule(1, 2, 200)).signedVolume, (4.0 + 4.0 / 3.0) * pi, 1e-2);
  EXPECT_NEAR(analyseConnectivity(wedge(60, 5, 2)).signedVolume, 5.0 * std::sqrt(3.0), 1e-12);
}

TEST(MeshConnectivity, VolumeIsAccurateFarFromTheOrigin)
{
  const TriangleMesh mesh = translated(box({ 0.5, 0.5, 0.5 }), { 1e6, -1e6, 1e6 });
  EXPECT_NEAR(analyseConnectivity(mesh).signedVolume, 1.0, 1e-12);
  EXPECT_NEAR(analyseConnectivity(flipOrientation(mesh)).signedVolume, -1.0, 1e-12);
}

TEST(MeshConnectivity, OpenBoxHasABoundary)
{
  TriangleMesh mesh = box({ 1, 1, 1 });
  mesh.triangles.resize(10);
  mesh.triangleCells.resize(10);
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_EQ(connectivity.boundaryEdges, 4);
  EXPECT_FALSE(connectivity.closed());
  EXPECT_TRUE(connectivity.manifold() && connectivity.oriented());
}

TEST(MeshConnectivity, ThreeFinsShareOneEdge)
{
  const MeshConnectivity connectivity = analysed(fins(3));
  EXPECT_EQ(connectivity.edges.size(), 7u);
  EXPECT_EQ(connectivity.nonManifoldEdges, 1);
  EXPECT_EQ(connectivity.boundaryEdges, 6);
  EXPECT_EQ(*std::max_element(connectivity.edgeTriangles.values.begin(),
              connectivity.edgeTriangles.values.end()),
    2);
  EXPECT_FALSE(connectivity.manifold());
  EXPECT_GE(connectivity.nonManifoldTriangles, 1);
}

TEST(MeshConnectivity, EveryFinIsInItsEdgesList)
{
  const MeshConnectivity connectivity = analysed(fins(9));
  const auto spine = std::find_if(connectivity.edges.begin(), connectivity.edges.end(),
    [](const std::array<int, 2>& edge) { return edge[0] + edge[1] == 1; });
  EXPECT_EQ(connectivity.edgeTriangles.size(static_cast<int>(spine - connectivity.edges.begin())),
    9);
}

TEST(MeshConnectivity, OpenBowTieIsOnePieceButNotManifold)
{
  const TriangleMesh mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { -1, 0, 0 }, { -1, -1, 0 } },
      { { 0, 1, 2 }, { 0, 3, 4 } });
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_EQ(connectivity.components, 1);
  EXPECT_EQ(connectivity.nonManifoldPoints, 1);
  EXPECT_FALSE(connectivity.manifold());
  EXPECT_EQ(connectivity.pointEdges.size(0), 4);
}

TEST(MeshConnectivity, ClosedBowTieIsClosedButNotManifold)
{
  const TriangleMesh tetrahedron = regularTetrahedron(std::sqrt(8.0));
  const TriangleMesh mesh = appended(tetrahedron, translated(box({ 1, 1, 1 }), { 2, 2, 2 }));
  EXPECT_EQ(mesh.points.size(), 4u + 8u - 1u);
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_TRUE(connectivity.closed() && connectivity.oriented());
  EXPECT_FALSE(connectivity.manifold());
  EXPECT_EQ(connectivity.components, 1);
}

TEST(MeshConnectivity, RefusedTrianglesAreNotPrinted)
{
  // Two closed fans around point 0, given in turn, and a third triangle at one of their edges.
  std::vector<Point3> points = { { 0, 0, 0 } };
  for (int i = 0; i < 6; ++i)
  {
    points.push_back({ std::cos(2.0 * i), std::sin(2.0 * i), i < 3 ? 1.0 : -1.0 });
  }
  ::testing::internal::CaptureStderr();
  const MeshConnectivity connectivity = analysed(makeMesh(points,
    { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 4, 5 }, { 0, 3, 1 }, { 0, 5, 6 }, { 0, 6, 4 }, { 1, 2, 4 },
      { 1, 2, 5 } }));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(connectivity.edges.size(), 12u + 4u);
  EXPECT_GE(connectivity.nonManifoldTriangles, 2);
}

TEST(MeshConnectivity, MisorientedPairIsCounted)
{
  const MeshConnectivity connectivity = analysed(
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } }, { { 0, 1, 2 }, { 1, 2, 3 } }));
  EXPECT_EQ(connectivity.misorientedEdges, 1);
  EXPECT_FALSE(connectivity.oriented());
  EXPECT_EQ(connectivity.edges.size(), 5u);
  EXPECT_EQ(connectivity.boundaryEdges, 4);
}

TEST(MeshConnectivity, MoebiusStripIsNotOriented)
{
  const TriangleMesh mesh = moebiusStrip(12);
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_EQ(connectivity.misorientedEdges, 1);
  EXPECT_EQ(connectivity.boundaryEdges, 24);
  EXPECT_EQ(connectivity.nonManifoldEdges, 0);
  EXPECT_EQ(eulerCharacteristic(mesh, connectivity), 0);
}

TEST(MeshConnectivity, DuplicatedFacesShareTheirEdges)
{
  TriangleMesh mesh = regularTetrahedron(1.0);
  mesh.triangles.push_back(mesh.triangles[2]);
  mesh.triangleCells.push_back(4);
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_EQ(connectivity.edges.size(), 6u);
  EXPECT_EQ(connectivity.nonManifoldEdges, 3);
  EXPECT_EQ(connectivity.nonManifoldTriangles, 1);
  EXPECT_FALSE(connectivity.closed());
}

TEST(MeshConnectivity, CollinearTrianglesCloseTheSurface)
{
  // A square whose bottom side has a middle point on one side only, filled by a flat triangle.
  const TriangleMesh mesh =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 }, { 1, -1, 0 } },
      { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 4 }, { 0, 2, 1 } });
  const MeshConnectivity connectivity = analysed(mesh);
  EXPECT_EQ(connectivity.boundaryEdges, 4);
  EXPECT_TRUE(connectivity.manifold() && connectivity.oriented());
}

TEST(MeshConnectivity, SegmentsOnATrianglesEdgeAreNotNewEdges)
{
  const MeshConnectivity connectivity =
    analysed(makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, 5 } }, { { 0, 1, 2 } },
      { { 1, 0 }, { 2, 3 }, { 3, 2 } }));
  EXPECT_EQ(connectivity.edges.size(), 4u);
  EXPECT_EQ(connectivity.segmentEdges, (std::vector<int>{ 0, 3, 3 }));
  EXPECT_EQ(connectivity.edgeTriangles.size(3), 0);
  EXPECT_EQ(connectivity.boundaryEdges, 3);
  EXPECT_EQ(connectivity.edgeCells, (std::vector<std::int64_t>{ 0, 0, 0, 2 }));
  EXPECT_EQ(connectivity.pointCells, (std::vector<std::int64_t>{ 0, 0, 0, 2 }));
}

TEST(MeshConnectivity, SegmentOnAClosedMeshLeavesItClosed)
{
  const TriangleMesh cube = box({ 1, 1, 1 });
  const auto& t = cube.triangles[0];
  EXPECT_TRUE(analysed(makeMesh(cube.points, cube.triangles, { { t[0], t[1] } })).closed());
  TriangleMesh whiskered = cube;
  whiskered.points.push_back({ 5, 5, 5 });
  EXPECT_FALSE(analysed(makeMesh(whiskered.points, cube.triangles, { { 0, 8 } })).closed());
  EXPECT_FALSE(analysed(makeMesh(whiskered.points, cube.triangles, {}, { 8 })).closed());
}

TEST(MeshConnectivity, ComponentsAreConnectedThroughPoints)
{
  EXPECT_EQ(analysed(shell(1, 2, 1)).components, 2);
  EXPECT_EQ(analysed(plates(1, 1)).components, 2);
  EXPECT_EQ(analysed(randomSoup(50, 1)).components, 50);
  const TriangleMesh mixed =
    makeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 5 }, { 9, 9, 9 }, { 8, 8, 8 } },
      { { 0, 1, 2 } }, { { 0, 3 } }, { 4, 5 });
  EXPECT_EQ(analysed(mixed).components, 3);
}

TEST(MeshConnectivity, TheManifoldPartIsThatOfAHalfEdgeMesh)
{
  std::mt19937 random(7);
  int refused = 0;
  for (int run = 0; run < 2000; ++run)
  {
    TriangleMesh mesh;
    mesh.points.resize(4 + random() % 5);
    const auto point = [&] { return static_cast<int>(random() % mesh.points.size()); };
    for (int i = 0; i < 14; ++i)
    {
      // Every other mesh has all triangles around one point.
      const std::array<int, 3> t{ run % 2 == 0 ? 0 : point(), point(), point() };
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      {
        mesh.triangles.push_back(t);
      }
    }
    mesh.triangleCells.resize(mesh.triangles.size());
    const int truth = refusedTriangles(mesh);
    ASSERT_EQ(analysed(mesh).nonManifoldTriangles, truth) << run;
    refused += truth;
  }
  EXPECT_GT(refused, 2000);
}

// The time was quadratic: longer here than a test may take.
TEST(MeshConnectivity, IsQuickHoweverManyTrianglesMeetAtAPoint)
{
  constexpr int kRim = 200000;
  const TriangleMesh mesh = doubleCone(kRim);
  const MeshConnectivity connectivity = analyseConnectivity(mesh);
  EXPECT_TRUE(connectivity.closed() && connectivity.manifold() && connectivity.oriented());
  EXPECT_EQ(connectivity.edges.size(), 3u * kRim);
  EXPECT_EQ(connectivity.pointEdges.size(0), kRim);
}

TEST(MeshConnectivity, RefusesBrokenMeshes)
{
  TriangleMesh mesh = regularTetrahedron(1.0);
  mesh.triangles[2] = { 0, 1, 4 };
  EXPECT_THROW(analyseConnectivity(mesh), Error);
  mesh.triangles[2] = { 0, 1, 1 };
  EXPECT_THROW(analyseConnectivity(mesh), Error);
  mesh = regularTetrahedron(1.0);
  mesh.triangleCells.pop_back();
  EXPECT_THROW(analyseConnectivity(mesh), Error);
}

TEST(MeshConnectivity, FiguresOfRealMeshes)
{
  // Generated, so that something is checked where the models are absent.
  EXPECT_EQ(eulerCharacteristic(torus(3, 1, 12, 8), analysed(torus(3, 1, 12, 8))), 0);
  for (const Figures& expected : { Figures{ "paper/triceratops.off", 1, 0, 0, 2 },
         Figures{ "paper/head_mannequin_13k.off", 1, 60, 0, 1 },
         Figures{ "soup/beetle_vw_2k.obj", 2, 296, 47, -3 },
         Figures{ "soup/chair_double_sided_12.8k.obj", 3, 0, 9518, 6387 },
         Figures{ "soup/elephant_holes_4.5k.off", 1, 1353, 0, -175 },
         Figures{ "selfint/footbones_26comp_4.2k.off", 26, 0, 0, 52 } })
  {
    const auto path = modelPath(expected.model);
    if (!path)
    {
      continue;
    }
    const TriangleMesh mesh = buildTriangleMesh(loadModel(*path));
    const MeshConnectivity connectivity = analysed(mesh);
    EXPECT_EQ(connectivity.components, expected.components) << expected.model;
    EXPECT_EQ(connectivity.boundaryEdges, expected.boundaryEdges) << expected.model;
    EXPECT_EQ(connectivity.nonManifoldEdges, expected.nonManifoldEdges) << expected.model;
    EXPECT_EQ(eulerCharacteristic(mesh, connectivity), expected.euler) << expected.model;
  }
}

namespace
{

/// Cancels when it is asked for the n-th time.
class CancelAt : public Progress
{
public:
  explicit CancelAt(int call)
    : left_(call)
  {
  }
  void report(double fraction, const char* /*phase*/) override { EXPECT_EQ(fraction, 0.0); }
  bool cancelled() override { return --left_ <= 0; }

private:
  int left_;
};

} // namespace

TEST(MeshConnectivity, CanBeCancelled)
{
  // Takes many times the 20 ms between two questions.
  const TriangleMesh mesh = icosphere(1.0, 8);
  for (const int call : { 1, 4 })
  {
    CancelAt progress(call);
    Execution execution;
    execution.progress = &progress;
    expectError([&] { analyseConnectivity(mesh, execution); }, ErrorCode::Cancelled);
  }
}
