#include "lib/ranks/pieces.h"
#include "lib/ranks/simulated_ranks.h"
#include "medial/axis_coverage.h"
#include "medial/cell_topology.h"
#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/medial_model.h"
#include "medial/ranks.h"
#include "support/named.h"
#include "support/shapes.h"
#include "support/transforms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <ostream>
#include <random>
#include <string>
#include <vector>

// Figures of axes in pieces, of whatever ranks have which cells.

namespace medial::test
{
namespace
{

/// A solid, and what of it is kept.
struct Case
{
  std::string name;
  TriangleMesh mesh;
  int resolution = 48;
  double angle = 60.0;
  Representation representation = Representation::Surface;
};

std::ostream& operator<<(std::ostream& stream, const Case& of)
{
  return stream << of.name;
}

/// Boxes with hollows: closed sheets that meet others along seams.
TriangleMesh boxWithHollows()
{
  TriangleMesh mesh = box({ 1.5, 0.8, 0.7 });
  for (const double x : { -0.7, 0.6 })
  {
    mesh = appended(mesh, translated(flipOrientation(icosphere(0.3, 2)), { x, 0.04, 0.02 }));
  }
  return mesh;
}

std::vector<Case> cases()
{
  return { { "torus", torus(0.8, 0.25, 40, 20) }, { "hollows", boxWithHollows() },
    { "shells", appended(shell(0.5, 1.0, 3), translated(shell(0.3, 0.6, 3), { 1.9, 0.1, 0.0 })) },
    { "curves", uvCapsule(0.05, 1.0, 24), 130 },
    { "points", torus(0.8, 0.25, 40, 20), 30, 60.0, Representation::Points },
    { "flat", box({ 1.0, 0.6, 0.1 }), 64, 100.0 } };
}

MedialAxis axisOf(const Case& of)
{
  MedialAxisOptions options;
  options.angle = of.angle;
  options.representation = of.representation;
  options.field.engine = Engine::Processor;
  return computeMedialAxis(of.mesh, makeGrid(of.mesh.bounds(), of.resolution), options);
}

/// Hands the cells of an axis out at random.
std::vector<AxisPiece> scattered(const MedialAxis& whole, int ranks)
{
  std::vector<AxisPiece> pieces(static_cast<std::size_t>(ranks));
  std::vector<std::map<std::int64_t, std::int64_t>> localOf(pieces.size());
  std::mt19937 random(7);
  std::int64_t number = 0;
  const auto hand = [&](const auto& cells, auto member)
  {
    for (auto cell : cells)
    {
      const std::size_t rank = random() % pieces.size();
      AxisPiece& piece = pieces[rank];
      for (std::int64_t& point : cell)
      {
        const auto [found, isNew] = localOf[rank].insert({ point, piece.axis.points.size() });
        if (isNew)
        {
          piece.axis.points.push_back(whole.points[point]);
          piece.axis.radius.push_back(whole.radius[point]);
          piece.globalPointIds.push_back(point);
        }
        point = found->second;
      }
      (piece.axis.*member).push_back(cell);
      piece.globalCellIds.push_back(number++);
    }
  };
  hand(whole.lines, &MedialAxis::lines);
  hand(whole.quads, &MedialAxis::quads);
  hand(whole.triangles, &MedialAxis::triangles);
  for (const std::int64_t vertex : whole.vertices)
  {
    AxisPiece& piece = pieces[random() % pieces.size()];
    piece.axis.vertices.push_back(static_cast<std::int64_t>(piece.axis.points.size()));
    piece.axis.points.push_back(whole.points[vertex]);
    piece.axis.radius.push_back(whole.radius[vertex]);
    piece.globalPointIds.push_back(vertex);
  }
  for (AxisPiece& piece : pieces)
  {
    piece.points = static_cast<std::int64_t>(whole.points.size());
    piece.cells = whole.cellCount();
  }
  return pieces;
}

class AxisPieces : public testing::TestWithParam<Case>
{
protected:
  const MedialAxis whole_ = axisOf(GetParam());
};

TEST_P(AxisPieces, HaveTheTopologyOfTheWhole)
{
  const CellTopology expected = topologyOf(whole_);
  ASSERT_GT(expected.components, 0);
  for (const int ranks : { 1, 2, 5, 16 })
  {
    SCOPED_TRACE(ranks);
    const std::vector<AxisPiece> pieces = scattered(whole_, ranks);
    SimulatedRanks(ranks).run(
      [&](Communicator& communicator)
      {
        const CellTopology found = topologyOf(communicator, pieces[communicator.rank()]);
        EXPECT_EQ(found.components, expected.components);
        EXPECT_EQ(found.eulerCharacteristic, expected.eulerCharacteristic);
        EXPECT_EQ(found.genus, expected.genus);
        EXPECT_EQ(found.cavities, expected.cavities);
      });
  }
}

TEST_P(AxisPieces, CoverWhatTheWholeCovers)
{
  const TriangleMesh mesh = numbered(GetParam().mesh);
  const MedialModel model = toMedialModel(whole_);
  constexpr double kReach = 0.002; // much is left out
  constexpr int kRanks = 3;
  const std::vector<AxisPiece> pieces = scattered(whole_, kRanks);
  for (const double negligible : { 0.0, 0.9 })
  {
    CoverageOptions options;
    options.samples = 2000;
    options.negligible = negligible;
    options.execution.threads = 1;
    const AxisCoverage expected = measureCoverage(mesh, model, kReach, options);
    SimulatedRanks(kRanks).run(
      [&](Communicator& communicator)
      {
        const int rank = communicator.rank();
        const AxisCoverage found = measureCoverage(communicator,
          pieceOf(mesh, rank, atRandom(kRanks)), pieces[rank], kReach, options);
        EXPECT_EQ(found.samples, expected.samples);
        EXPECT_EQ(found.reach, expected.reach);
        EXPECT_EQ(found.uncoveredShare, expected.uncoveredShare);
        ASSERT_EQ(found.places.size(), expected.places.size());
        for (std::size_t i = 0; i < found.places.size(); ++i)
        {
          EXPECT_EQ(found.places[i].point, expected.places[i].point);
          EXPECT_EQ(found.places[i].share, expected.places[i].share);
        }
      });
  }
}

INSTANTIATE_TEST_SUITE_P(Solids, AxisPieces, testing::ValuesIn(cases()), kNameOfParameter);

TEST(AxisPiecesTopology, OfClosedSheetsCountsCavities)
{
  Case hollows{ "", boxWithHollows() };
  const MedialAxis whole = axisOf(hollows);
  EXPECT_EQ(topologyOf(whole).cavities, 2);
}

TEST(AxisPiecesCoverage, RefusesOnEveryRank)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 1));
  SimulatedRanks(2).run(
    [&](Communicator& communicator)
    {
      const SurfacePiece piece = pieceOf(mesh, communicator.rank(), atRandom(2));
      EXPECT_THROW(measureCoverage(communicator, piece, {}, -1.0), Error);
      const AxisCoverage nothing = measureCoverage(communicator, piece, {}, 0.1);
      EXPECT_EQ(nothing.uncoveredShare, 1.0);
    });
}

} // namespace
} // namespace medial::test
