#include "medial/error.h"
#include "medial/ranks.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"

#include "lib/ranks/pieces.h"
#include "lib/ranks/same_bits.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/point_math.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

using namespace medial;
using namespace medial::test;

namespace
{

/// Corners of triangles by their numbers in the whole, in the order of each cell.
using Triangles = std::map<std::int64_t, std::vector<std::array<std::int64_t, 3>>>;

/// Adds the triangles of a mesh.
/// @param numberOf returns the number of a point.
template <typename NumberOf>
void add(const TriangleMesh& mesh, const NumberOf& numberOf, Triangles& triangles)
{
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    const auto& [a, b, c] = mesh.triangles[i];
    triangles[mesh.triangleCells[i]].push_back({ numberOf(a), numberOf(b), numberOf(c) });
  }
}

/// Expects the points of a piece where the whole has them, new ones in the middle of their parents,
/// but corners of other pieces between them.
/// @param known number of the points of the undivided whole.
void expectPoints(const PieceSubdivision& fine, const TriangleMesh& whole, std::size_t known)
{
  const SurfacePiece& piece = fine.piece;
  ASSERT_EQ(piece.pointOrder.size(), piece.mesh.points.size());
  for (std::size_t i = 0; i < piece.pointOrder.size(); ++i)
  {
    ASSERT_LT(piece.pointOrder[i], static_cast<std::int64_t>(whole.points.size()));
    EXPECT_EQ(piece.mesh.points[i], whole.points[piece.pointOrder[i]]);
  }
  const std::size_t original = piece.mesh.points.size() - fine.parents.size();
  for (std::size_t i = 0; i < fine.parents.size(); ++i)
  {
    const auto& [a, b] = fine.parents[i];
    EXPECT_LT(a, static_cast<int>(original + i));
    EXPECT_LT(b, static_cast<int>(original + i));
    if (piece.pointOrder[original + i] < static_cast<std::int64_t>(known))
    {
      const Point3& corner = piece.mesh.points[original + i];
      const double length = distance(piece.mesh.points[a], piece.mesh.points[b]);
      EXPECT_LT(distance(corner, piece.mesh.points[a]), length);
      EXPECT_LT(distance(corner, piece.mesh.points[b]), length);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(piece.mesh.points[original + i][axis],
        0.5 * (piece.mesh.points[a][axis] + piece.mesh.points[b][axis]));
    }
  }
}

void expectThatOfOneProcess(const TriangleMesh& mesh, double maxEdge, int ranks,
  const Distribution& rankOf)
{
  const TriangleMesh whole = subdivide(mesh, maxEdge).mesh;
  Triangles expected;
  add(
    whole, [](int point) { return std::int64_t{ point }; }, expected);
  std::vector<PieceSubdivision> pieces(static_cast<std::size_t>(ranks));
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      pieces[communicator.rank()] =
        subdivide(communicator, pieceOf(mesh, communicator.rank(), rankOf), maxEdge);
    });
  Triangles found;
  for (const PieceSubdivision& fine : pieces)
  {
    EXPECT_FALSE(fine.piece.weld);
    expectPoints(fine, whole, mesh.points.size());
    add(
      fine.piece.mesh, [&](int point) { return fine.piece.pointOrder[point]; }, found);
  }
  EXPECT_EQ(found, expected) << ranks << " ranks";
}

void expectThatOfOneProcess(const TriangleMesh& mesh, double maxEdge)
{
  for (const int ranks : { 1, 2, 3, 7 })
  {
    expectThatOfOneProcess(mesh, maxEdge, ranks, atRandom(ranks));
  }
  expectThatOfOneProcess(mesh, maxEdge, 3, inRows(3, mesh.triangles.size()));
  expectThatOfOneProcess(mesh, maxEdge, 3, onTheLast(3));
}

/// Two boxes that touch at points which only their division makes.
TriangleMesh touchingBoxes()
{
  return numbered(
    appended(box({ 1.0, 0.9, 0.8 }), translated(box({ 0.1, 0.7, 0.5 }), { 0.0, 0.0, 1.3 })));
}

std::string messageOf(double maxEdge)
{
  std::vector<std::string> messages(2);
  const TriangleMesh mesh = touchingBoxes();
  SimulatedRanks(2).run(
    [&](Communicator& communicator)
    {
      try
      {
        subdivide(communicator, pieceOf(mesh, communicator.rank(), atRandom(2)), maxEdge);
      }
      catch (const Error& error)
      {
        messages[communicator.rank()] = error.what();
      }
    });
  EXPECT_EQ(messages[0], messages[1]);
  return messages[0];
}

} // namespace

TEST(SubdividedPieces, OfBoxesThatTouchAreThoseOfOneProcess)
{
  for (const double maxEdge : { 5.0, 1.0, 0.3, 0.11 })
  {
    expectThatOfOneProcess(touchingBoxes(), maxEdge);
  }
}

// Short and long edges meet in all ways.
TEST(SubdividedPieces, OfTrianglesOfAllSizesAreThoseOfOneProcess)
{
  expectThatOfOneProcess(damagedSolids(3), 0.2);
  expectThatOfOneProcess(moebiusStrips(), 0.15);
  expectThatOfOneProcess(numbered(torus(0.8, 0.23, 24, 9)), 0.1);
}

// Corners on edges of other pieces.
TEST(SubdividedPieces, OfTrianglesWithoutAreaAreThoseOfOneProcess)
{
  for (const unsigned int seed : { 1U, 2U, 3U })
  {
    const TriangleMesh mesh = withFlatTriangles(touchingBoxes(), 30, 0.0, seed);
    EXPECT_GT(mesh.degenerateTriangles, 5);
    for (const double maxEdge : { 5.0, 0.4 })
    {
      expectThatOfOneProcess(mesh, maxEdge);
    }
  }
}

TEST(SubdividedPieces, HaveTheThicknessOfOneProcess)
{
  ThicknessOptions options;
  options.method = ThicknessMethod::Wall;
  options.execution.threads = 1;
  const TriangleMesh clean = touchingBoxes();
  for (const TriangleMesh& mesh : { clean, withFlatTriangles(clean, 30, 0.0, 1) })
  {
    const Thickness whole = computeThickness(subdivide(mesh, 0.4).mesh, options);
    for (const int ranks : { 1, 2, 3, 7 })
    {
      SimulatedRanks(ranks).run(
        [&](Communicator& communicator)
        {
          const SurfacePiece piece = pieceOf(mesh, communicator.rank(), atRandom(ranks));
          const SurfacePiece fine = subdivide(communicator, piece, 0.4).piece;
          const Thickness part = computeThickness(communicator, fine, options);
          EXPECT_EQ(part.points, whole.points);
          ASSERT_EQ(part.values.size(), fine.pointOrder.size());
          for (std::size_t i = 0; i < part.values.size(); ++i)
          {
            EXPECT_TRUE(sameBits(part.values[i], whole.values[fine.pointOrder[i]]));
          }
        });
    }
  }
}

TEST(SubdividedPieces, RefuseWhatOneProcessRefuses)
{
  for (const double maxEdge : { 0.0, -1.0, 1e-9 })
  {
    std::string expected;
    try
    {
      subdivide(touchingBoxes(), maxEdge);
    }
    catch (const Error& error)
    {
      expected = error.what();
    }
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(messageOf(maxEdge), expected);
  }
}
