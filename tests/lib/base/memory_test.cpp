#include "medial/memory.h"

#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/reconstruction.h"
#include "support/axes.h"
#include "support/errors.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

namespace
{

using medial::ErrorCode;

/// More than any machine has: 8192 points along each axis.
constexpr std::int64_t kHugeGrid = std::int64_t{ 8192 } * 8192 * 8192;

/// The message of the OutOfMemory error of `work`, empty if there is none.
template <typename Work>
std::string memoryError(const Work& work)
{
  return medial::test::messageOf(work, ErrorCode::OutOfMemory);
}

TEST(AvailableMemory, IsPlausible)
{
  EXPECT_GT(medial::availableMemory(), std::uint64_t{ 64 } << 20);
  EXPECT_LT(medial::availableMemory(), std::uint64_t{ 1 } << 50);
}

TEST(AvailableMemory, WhatFitsIsGranted)
{
  EXPECT_EQ(memoryError([] { medial::requireMemory(1000000, 29); }), "");
}

TEST(AvailableMemory, TheMessageHasTheFigures)
{
  const std::string message = memoryError([] { medial::requireMemory(kHugeGrid, 29); });
  EXPECT_NE(message.find("549755813888 points needs 15204352 MiB (29 bytes"), std::string::npos)
    << message;
}

TEST(AvailableMemory, TheMessageSaysWhatNeedsIt)
{
  const std::string message = memoryError(
    [] { medial::requireMemory("a medial axis of 5 cells", std::uint64_t{ 1 } << 60); });
  EXPECT_EQ(message.rfind("a medial axis of 5 cells needs 1099511627776 MiB, but only ", 0), 0)
    << message;
}

TEST(AvailableMemory, PreservedTopologyOfAHugeGridIsRefused)
{
  const medial::TriangleMesh mesh = medial::test::box({ 1, 1, 1 });
  medial::MedialAxisOptions options;
  options.topology = medial::Topology::Preserve;
  EXPECT_NE(memoryError([&]
              { medial::computeMedialAxis(mesh, medial::makeGrid(mesh.bounds(), 8192), options); }),
    "");
}

TEST(AvailableMemory, TheFieldOfAUnionOnAHugeGridIsRefused)
{
  const medial::MedialModel model = medial::test::ballModel(1.0);
  const medial::Grid grid = medial::makeGrid(medial::modelBounds(model), 8192);
  EXPECT_NE(memoryError([&] { medial::computeReconstruction(model, grid); }), "");
}

} // namespace
