// Fields as level sets of OpenVDB, in builds that have it.
#include "command_output.h"

#include "files/scans/scan_reader.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <openvdb/openvdb.h>

namespace medial::test
{
namespace
{

TEST_F(CommandOutput, VdbHasTheDistancesOfItsBand)
{
  run({ "--field", folder.file("field.vti") });
  run({ "--field", folder.file("field.vdb"), "--band", "2" });
  const files::Scan expected = files::readScan(folder.file("field.vti"));
  vtkDataArray* distances = expected.image->GetPointData()->GetScalars();

  openvdb::initialize();
  openvdb::io::File file(folder.file("field.vdb"));
  file.open();
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid("distance"));
  EXPECT_EQ(grid->getGridClass(), openvdb::GRID_LEVEL_SET);
  const double band = 2.0 * expected.frame[0][0];
  EXPECT_NEAR(grid->background(), band, 1e-6);
  const openvdb::FloatGrid::ConstAccessor values = grid->getConstAccessor();
  const int* size = expected.image->GetDimensions();
  int near = 0;
  vtkIdType i = 0;
  for (int z = 0; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x, ++i)
      {
        const double distance = distances->GetComponent(i, 0);
        const openvdb::Coord at(x, y, z);
        const auto limited = static_cast<float>(std::max(-band, std::min(band, distance)));
        ASSERT_NEAR(values.getValue(at), limited, 1e-6) << x << ' ' << y << ' ' << z;
        const bool isNear = std::abs(static_cast<float>(distance)) < grid->background();
        ASSERT_EQ(values.isValueOn(at), isNear) << x << ' ' << y << ' ' << z;
        near += isNear ? 1 : 0;
        const openvdb::Vec3d point = grid->indexToWorld(at);
        for (int axis = 0; axis < 3; ++axis)
        {
          const int index = axis == 0 ? x : axis == 1 ? y : z;
          const auto& row = expected.frame[static_cast<std::size_t>(axis)];
          ASSERT_NEAR(point[axis], row[static_cast<std::size_t>(axis)] * index + row[3], 1e-9);
        }
      }
    }
  }
  EXPECT_GT(near, 1000);
  EXPECT_LT(near, distances->GetNumberOfTuples());
}

} // namespace
} // namespace medial::test
