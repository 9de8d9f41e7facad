// Rows of distances, which are kept in few bytes, against the distances themselves.
#include "thickness/depth_rows.h"
#include "thickness/tile_radii.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

using namespace medial;

namespace
{

constexpr float kOther = -7.0f; ///< what points on the other side keep

using Row = std::vector<float>;

DepthRows rowsOf(const std::vector<Row>& rows)
{
  DepthRows made;
  for (const Row& row : rows)
  {
    made.add(row.data(), row.size());
  }
  made.finish();
  return made;
}

void expectRow(const DepthRows& rows, std::size_t number, const Row& expected)
{
  Row read(expected.size(), kOther);
  rows.read(number, read.data());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    if (expected[i] > 0.0f)
    {
      EXPECT_GT(read[i], 0.0f) << i;
      EXPECT_EQ(roundedRadius(read[i]), roundedRadius(expected[i])) << i;
    }
    else
    {
      EXPECT_EQ(read[i], kOther) << i;
    }
  }
}

/// Distances from places on the row, which are the deepest.
Row wave(std::size_t length, float period)
{
  Row row;
  for (std::size_t i = 0; i < length; ++i)
  {
    row.push_back(20.0f * std::sin(static_cast<float>(i) / period) - 3.0f);
  }
  return row;
}

} // namespace

TEST(DepthRows, KeepDistancesOfOneSide)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-8000.0f, 8000.0f);
  std::vector<Row> rows{ {}, { -1.0f }, { 3.0f }, { 0.0f, 1e-9f, 0.0009f, 0.001f, 8191.0f, 0.0f },
    wave(100, 9.0f) };
  rows.emplace_back();
  for (int i = 0; i < 300; ++i)
  {
    rows.back().push_back(any(random));
  }
  const DepthRows kept = rowsOf(rows);
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    expectRow(kept, row, rows[row]);
  }
}

TEST(DepthRows, TakeAboutAByteForEachPointOnTheSide)
{
  const std::vector<Row> rows(50, wave(10000, 50.0f));
  EXPECT_LT(rowsOf(rows).byteCount(), 300000); // half of the points are on the side
}
