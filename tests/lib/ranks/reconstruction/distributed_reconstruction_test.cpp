#include "balls/ball_union.h"
#include "base/extents.h"
#include "medial/error.h"
#include "medial/ranks.h"
#include "medial/reconstruction.h"
#include "ranks/reconstruction/near_primitives.h"

#include "lib/ranks/message_of_ranks.h"
#include "lib/ranks/simulated_ranks.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

/// A bent sheet of quads with a frill of triangles and lines, and balls that are alone. Many
/// distances are equal: radii and places repeat.
MedialModel sheet(int size)
{
  MedialModel model;
  const auto add = [&model](double x, double y, double z, double radius)
  {
    model.centres.push_back({ x, y, z });
    model.radii.push_back(radius);
    return static_cast<std::int64_t>(model.centres.size()) - 1;
  };
  for (int i = 0; i < size; ++i)
  {
    for (int j = 0; j < size; ++j)
    {
      const double u = 0.25 * i;
      const double v = 0.25 * j;
      const std::int64_t corner =
        add(u, v, 0.3 * std::sin(u), i % 3 == 0 ? 0.25 : 0.2 + 0.05 * std::cos(v));
      if (i > 0 && j > 0)
      {
        model.quads.push_back({ corner, corner - 1, corner - size - 1, corner - size });
      }
    }
  }
  for (int j = 1; j < size; ++j)
  {
    const std::int64_t tip = add(-0.5, 0.25 * j - 0.125, 0.25, 0.1);
    model.triangles.push_back({ j, j - 1, tip });
    model.lines.push_back({ tip, add(-0.75, 0.25 * j - 0.125, 0.5, 0.125) });
    add(-1.0, 0.25 * j, 0.0, 0.125); // alone
  }
  return model;
}

/// Cells over balls at random places, of very different sizes: inside each other, in a line, and
/// the same twice.
MedialModel soup(unsigned seed)
{
  std::mt19937 random(seed);
  const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
  MedialModel model;
  for (int cell = 0; cell < 60; ++cell)
  {
    const auto first = static_cast<std::int64_t>(model.centres.size());
    const Point3 centre{ 4.0 * share(), 3.0 * share(), 2.0 * share() };
    for (int corner = 0; corner < 4; ++corner)
    {
      model.centres.push_back({ centre[0] + 0.5 * share(), centre[1] + 0.5 * share(),
        centre[2] + (cell % 5 == 0 ? 0.0 : 0.5 * share()) });
      model.radii.push_back(cell % 7 == 0 ? 0.0 : 0.3 * share() * share());
    }
    const int kind = cell % 4;
    if (kind == 0)
    {
      model.quads.push_back({ first, first + 1, first + 2, first + 3 });
      model.quads.push_back({ first, first + 1, first + 2, first + 3 });
    }
    else if (kind == 1)
    {
      model.triangles.push_back({ first, first + 1, first + 2 });
      model.triangles.push_back({ first + 3, first + 3, first + 2 });
    }
    else if (kind == 2)
    {
      model.lines.push_back({ first, first + 1 });
    }
  }
  return model;
}

/// Which rank has a cell, or a ball that no cell has.
using Sharing = std::function<int()>;

/// Returns pieces with the balls that their cells use.
std::vector<MedialModel> piecesOf(const MedialModel& model, int ranks, const Sharing& next)
{
  std::vector<MedialModel> pieces(static_cast<std::size_t>(ranks));
  std::vector<std::vector<std::int64_t>> numbers(pieces.size(),
    std::vector<std::int64_t>(model.centres.size(), -1));
  std::vector<char> used(model.centres.size(), 0);
  const auto ballIn = [&](int rank, std::int64_t ball)
  {
    MedialModel& piece = pieces[rank];
    std::int64_t& number = numbers[rank][ball];
    if (number < 0)
    {
      number = static_cast<std::int64_t>(piece.centres.size());
      piece.centres.push_back(model.centres[ball]);
      piece.radii.push_back(model.radii[ball]);
    }
    used[ball] = 1;
    return number;
  };
  const auto share = [&](const auto& cells, auto ofPiece)
  {
    for (auto cell : cells)
    {
      const int rank = next();
      for (std::int64_t& ball : cell)
      {
        ball = ballIn(rank, ball);
      }
      (pieces[rank].*ofPiece).push_back(cell);
    }
  };
  share(model.lines, &MedialModel::lines);
  share(model.quads, &MedialModel::quads);
  share(model.triangles, &MedialModel::triangles);
  for (std::size_t ball = 0; ball < used.size(); ++ball)
  {
    if (!used[ball])
    {
      ballIn(next(), static_cast<std::int64_t>(ball));
    }
  }
  return pieces;
}

/// Returns how many values of a part of a field are others than those of the whole. Far from the
/// surface only the sign counts, and that the surface is far.
std::size_t differences(const Grid& grid, const std::vector<float>& whole, const Extent& extent,
  const std::vector<float>& part)
{
  EXPECT_EQ(static_cast<std::int64_t>(part.size()), extent.pointCount());
  const auto band =
    static_cast<float>(3.0 * *std::max_element(grid.spacing.begin(), grid.spacing.end()));
  std::size_t count = 0;
  std::size_t at = 0;
  for (int k = extent.min[2]; k <= extent.max[2]; ++k)
  {
    for (int j = extent.min[1]; j <= extent.max[1]; ++j)
    {
      for (int i = extent.min[0]; i <= extent.max[0]; ++i, ++at)
      {
        const float expected =
          whole[(static_cast<std::size_t>(k) * grid.dimensions[1] + j) * grid.dimensions[0] + i];
        const bool near = std::abs(expected) < band;
        const bool sameSign = std::signbit(expected) == std::signbit(part[at]); // of zeros, too
        const bool alike = near ? expected == part[at] && sameSign
                                : std::abs(part[at]) >= band && (part[at] < 0) == (expected < 0);
        count += alike ? 0 : 1;
      }
    }
  }
  return count;
}

void expectFieldOfOne(const MedialModel& model, int resolution, int ranks, const Sharing& next,
  const ReconstructionOptions& options = {})
{
  const Grid grid = makeGrid(modelBounds(model), resolution);
  const std::vector<float> whole = computeReconstruction(model, grid, options);
  const std::vector<MedialModel> pieces = piecesOf(model, ranks, next);
  const std::vector<Extent> parts = partsOfGrid(grid, ranks);
  std::atomic<std::size_t> different = 0;
  SimulatedRanks(ranks).run(
    [&](Communicator& communicator)
    {
      const MedialModel& piece = pieces[communicator.rank()];
      const Bounds bounds = modelBounds(communicator, piece);
      const Bounds expected = modelBounds(model);
      EXPECT_EQ(bounds.min, expected.min);
      EXPECT_EQ(bounds.max, expected.max);
      const Extent extent = grown(parts[communicator.rank()], 1, grid.wholeExtent());
      different += differences(grid, whole, extent,
        computeReconstruction(communicator, piece, grid, extent, options));
    });
  EXPECT_EQ(different, 0U) << ranks << " ranks at " << resolution;
}

Sharing atRandom(int ranks, unsigned seed)
{
  return [random = std::mt19937(seed), ranks]() mutable
  { return static_cast<int>(random() % static_cast<unsigned>(ranks)); };
}

TEST(DistributedReconstruction, FieldIsThatOfOneProcess)
{
  for (const int ranks : { 1, 2, 3, 7 })
  {
    expectFieldOfOne(sheet(12), 70, ranks, atRandom(ranks, 1));
    expectFieldOfOne(soup(1), 90, ranks, atRandom(ranks, 2));
    expectFieldOfOne(soup(2), 50, ranks, atRandom(ranks, 3), { false, {} });
  }
}

TEST(DistributedReconstruction, PiecesAndPartsOfTheGridMayBeEmpty)
{
  for (const int ranks : { 3, 7, 16 })
  {
    expectFieldOfOne(soup(3), 40, ranks, [ranks] { return ranks - 1; });
    expectFieldOfOne(soup(4), 12, ranks, atRandom(ranks, 5)); // one block of the grid
  }
}

TEST(DistributedReconstruction, EveryCellMayBeAPieceOfItsOwn)
{
  MedialModel model = soup(5);
  expectFieldOfOne(model, 60, 16, [rank = 0]() mutable { return rank++ % 16; });
}

TEST(DistributedReconstruction, DistancesDependOnNoOrder)
{
  const MedialModel model = soup(6);
  BallPrimitives parts = primitivesOf(model, true);
  const BallUnion solid(parts);
  std::mt19937 random(1);
  std::shuffle(parts.primitives.begin(), parts.primitives.end(), random);
  const BallUnion shuffled(parts);
  std::size_t different = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const auto share = [&random] { return static_cast<double>(random()) / 4294967296.0; };
    const glm::dvec3 x{ 5.0 * share() - 0.5, 4.0 * share() - 0.5, 3.0 * share() - 0.5 };
    const double distance = solid.distance(x, HUGE_VAL);
    different += distance != shuffled.distance(x, HUGE_VAL) ? 1 : 0;
    ASSERT_NEAR(distance, solid.nearest(x).distance, 1e-9);
    const double limit = distance + 0.1 * share();
    different += distance != shuffled.distance(x, limit) ? 1 : 0;
    ASSERT_EQ(solid.distance(x, distance - 0.1), distance - 0.1);
  }
  EXPECT_EQ(different, 0U);
}

TEST(DistributedReconstruction, NoRankHoldsTheWholeModel)
{
  constexpr int kRanks = 8;
  const MedialModel model = sheet(60);
  const std::size_t all = primitivesOf(model, true).primitives.size();
  const std::vector<MedialModel> pieces = piecesOf(model, kRanks, atRandom(kRanks, 7));
  const Grid grid = makeGrid(modelBounds(model), 200);
  const std::vector<Extent> parts = partsOfGrid(grid, kRanks);
  SimulatedRanks(kRanks).run(
    [&](Communicator& communicator)
    {
      const int rank = communicator.rank();
      const BallPrimitives near =
        nearPrimitives(communicator, primitivesOf(pieces[rank], true), grid, parts[rank]);
      EXPECT_LT(near.primitives.size(), all / 2);
      EXPECT_GT(near.primitives.size(), 0U);
    });
}

TEST(DistributedReconstruction, WhatFailsOnOneRankFailsOnAll)
{
  const Grid grid = makeGrid(modelBounds(soup(1)), 20);
  const auto message = [&](const std::function<void(int, MedialModel&, Extent&)>& spoil)
  {
    return messageOfRanks(3,
      [&](Communicator& communicator)
      {
        MedialModel piece = communicator.rank() == 0 ? soup(1) : MedialModel{};
        Extent extent = partsOfGrid(grid, 3)[communicator.rank()];
        spoil(communicator.rank(), piece, extent);
        modelBounds(communicator, piece);
        computeReconstruction(communicator, piece, grid, extent);
      });
  };
  EXPECT_EQ(message([](int, MedialModel&, Extent&) {}), "");
  EXPECT_EQ(message([](int, MedialModel& piece, Extent&) { piece = {}; }),
    "the medial axis has 0 points");
  EXPECT_EQ(message(
              [](int rank, MedialModel& piece, Extent&)
              {
                if (rank == 2)
                {
                  piece.lines = { { 0, 1 } };
                }
              }),
    "rank 2: the medial axis has 0 points");
  EXPECT_EQ(message(
              [](int rank, MedialModel& piece, Extent&)
              {
                if (rank == 1)
                {
                  piece.centres = { { 0, 0, 0 } };
                  piece.radii = { -1.0 };
                }
              }),
    "rank 1: point 0: radius -1 is outside [0, 1e+100]");
  EXPECT_EQ(message([](int rank, MedialModel&, Extent& extent)
              { extent.max[1] = rank == 1 ? extent.min[1] + 1000 : extent.max[1]; }),
    "rank 1: the extent leaves the grid");
}

} // namespace
} // namespace medial::test
