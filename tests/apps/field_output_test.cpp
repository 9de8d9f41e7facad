#include "failure.h"
#include "program.h"
#include "volumes/field_output.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataReader.h>

#include <gtest/gtest.h>

#include <string>

namespace medial::test
{
namespace
{

using namespace medial::app;
namespace fs = std::filesystem;

Grid gridOf(int x, int y, int z)
{
  Grid grid;
  grid.dimensions = { x, y, z };
  return grid;
}

std::uint64_t freeSpace(const TemporaryFolder& folder)
{
  return fs::space(folder.path()).available;
}

TEST(FieldLayout, OffsetsDoNotWrapAround)
{
  const Grid grid = gridOf(8192, 8192, 8192);
  const FieldLayout layout(grid, grid.wholeExtent());
  const std::uint64_t points = std::uint64_t{ 1 } << 39;
  const std::uint64_t slice = std::uint64_t{ 1 } << 26;
  const std::uint64_t start = layout.header().size();
  EXPECT_EQ(layout.sliceOffset(0, 0), start + 8);
  EXPECT_EQ(layout.arraySize(1), 12 * points);
  EXPECT_EQ(layout.sliceOffset(1, 8191), start + 8 + 4 * points + 8 + 12 * slice * 8191);
  EXPECT_EQ(layout.sliceOffset(4, 8191), start + 5 * 8 + 25 * points + 4 * slice * 8191);
  EXPECT_EQ(layout.footerOffset(), start + 5 * 8 + 29 * points);
  const std::string offset = " offset=\"" + std::to_string(4 * 8 + 25 * points) + "\"";
  EXPECT_NE(layout.header().find(offset), std::string::npos) << layout.header();
}

TEST(FieldLayout, SlicesCountFromTheFirstOfThePiece)
{
  const Grid grid = gridOf(3, 5, 200);
  const FieldLayout layout(grid, { { 0, 0, 64 }, { 2, 4, 128 } });
  EXPECT_EQ(layout.sliceOffset(0, 64), layout.lengthOffset(0) + 8);
  EXPECT_EQ(layout.sliceOffset(1, 66) - layout.sliceOffset(1, 64), 2u * 15u * 12u);
  EXPECT_EQ(layout.arraySize(3), 65u * 15u);
}

TEST(FieldPieces, ShareASliceAndCoverTheGrid)
{
  for (const int slices : { 1, 2, 64, 65, 66, 128, 129, 130, 1000 })
  {
    const auto pieces = fieldPieces(gridOf(7, 3, slices));
    EXPECT_EQ(pieces.size(), slices <= 65 ? 1u : static_cast<std::size_t>((slices + 62) / 64));
    EXPECT_EQ(pieces.front().min, (std::array<int, 3>{ 0, 0, 0 }));
    EXPECT_EQ(pieces.back().max, (std::array<int, 3>{ 6, 2, slices - 1 }));
    for (std::size_t i = 1; i < pieces.size(); ++i)
    {
      EXPECT_EQ(pieces[i].min[2], pieces[i - 1].max[2]);
      EXPECT_GT(pieces[i].max[2], pieces[i].min[2]);
    }
  }
}

TEST(PositionedFile, TellsThatTheDiskIsFull)
{
  PositionedFile file("/dev/full");
  try
  {
    file.write("value", 5, 0);
    ADD_FAILURE() << "no failure";
  }
  catch (const Failure& failure)
  {
    EXPECT_EQ(failure.exitCode(), ExitCode::NoSpace);
    EXPECT_EQ(failure.what(), std::string("No space left on device"));
  }
}

TEST(FieldOutput, LeavesNothingBehindWithoutCommit)
{
  const TemporaryFolder folder;
  for (const char* name : { "field.vti", "field.pvti" })
  {
    FieldOutput output(folder.file(name));
    EXPECT_EQ(folder.list(), std::vector<std::string>());
    output.begin(gridOf(4, 4, 100));
    EXPECT_FALSE(folder.list().empty());
  }
  EXPECT_EQ(folder.list(), std::vector<std::string>());
}

TEST(FieldOutput, RefusesAtOnceWhatTheDiskCannotHold)
{
  const TemporaryFolder folder;
  const Grid grid = gridOf(8192, 8192, 8192);
  if (freeSpace(folder) > FieldLayout(grid, grid.wholeExtent()).fileSize())
  {
    GTEST_SKIP() << "this disk can hold the largest field";
  }
  for (const char* name : { "field.vti", "field.pvti" })
  {
    FieldOutput output(folder.file(name));
    try
    {
      output.begin(grid);
      ADD_FAILURE() << "no failure";
    }
    catch (const Failure& failure)
    {
      EXPECT_EQ(failure.exitCode(), ExitCode::NoSpace);
      const std::string message = failure.what();
      EXPECT_NE(message.find(std::string(name) + ": cannot be written: it takes 15"),
        std::string::npos)
        << message;
    }
  }
  EXPECT_EQ(folder.list(), std::vector<std::string>());
}

// A sparse file: all of the grid but its last slab is a hole.
TEST(FieldOutput, WritesBeyondFourGibibytes)
{
  const TemporaryFolder folder;
  const Grid grid = gridOf(512, 512, 601);
  EXPECT_GT(FieldLayout(grid, grid.wholeExtent()).fileSize(), std::uint64_t{ 1 } << 32);
  if (freeSpace(folder) < std::uint64_t{ 8 } << 30)
  {
    GTEST_SKIP() << "less than 8 GiB are free in " << folder.path();
  }
  FieldOutput output(folder.file("field.vti"));
  output.begin(grid);
  Extent slab = grid.wholeExtent();
  slab.min[2] = 599;
  const FieldArrays arrays = output.slabArrays(slab);
  for (std::int64_t i = 0; i < slab.pointCount(); ++i)
  {
    arrays.distance[i] = 0.5f;
    arrays.closestPoint[3 * i] = arrays.closestPoint[3 * i + 1] = 1.5f;
    arrays.closestPoint[3 * i + 2] = 2.5f;
    arrays.closestCell[i] = i;
    arrays.closestFeature[i] = 2;
    arrays.closestSite[i] = static_cast<std::int32_t>(-i);
  }
  output.stored(slab);
  output.finish();
  output.commit();

  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(folder.file("field.vti").c_str());
  reader->UpdateInformation();
  const int last[6] = { 0, 511, 0, 511, 600, 600 };
  static_cast<vtkAlgorithm*>(reader.GetPointer())->UpdateExtent(last);
  vtkPointData* data = reader->GetOutput()->GetPointData();
  constexpr vtkIdType kSlice = 512 * 512;
  ASSERT_EQ(data->GetNumberOfTuples(), kSlice);
  for (vtkIdType i = 0; i < kSlice; i += 1001)
  {
    ASSERT_EQ(data->GetArray("Distance")->GetTuple1(i), 0.5);
    ASSERT_EQ(data->GetArray("ClosestPoint")->GetTuple3(i)[2], 2.5);
    ASSERT_EQ(data->GetArray("ClosestCell")->GetTuple1(i), kSlice + i);
    ASSERT_EQ(data->GetArray("ClosestFeature")->GetTuple1(i), 2.0);
    ASSERT_EQ(data->GetArray("ClosestSite")->GetTuple1(i), -(kSlice + i));
  }
}

} // namespace
} // namespace medial::test
