#include "vdb_module.h"

#include "failure.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

namespace medial::app
{
namespace
{

class VdbFile : public ValueFile
{
public:
  VdbFile(const char* file, const Grid& grid, double band)
    : file_(file)
    , dimensions_(grid.dimensions)
    , limit_(static_cast<float>(band * *std::max_element(grid.spacing.begin(), grid.spacing.end())))
    , volume_(openvdb::FloatGrid::create(limit_))
  {
    openvdb::initialize();
    openvdb::math::Mat4d frame = openvdb::math::Mat4d::identity();
    frame.preScale(openvdb::Vec3d(grid.spacing[0], grid.spacing[1], grid.spacing[2]));
    frame.setTranslation(openvdb::Vec3d(grid.origin[0], grid.origin[1], grid.origin[2]));
    volume_->setTransform(openvdb::math::Transform::createLinearTransform(frame));
    volume_->setName("distance");
  }

  void write(const void* bytes, std::uint64_t count, std::uint64_t offset) override
  {
    const auto* values = static_cast<const float*>(bytes);
    const auto row = static_cast<std::uint64_t>(dimensions_[0]);
    const auto slice = row * static_cast<std::uint64_t>(dimensions_[1]);
    openvdb::FloatGrid::Accessor accessor = volume_->getAccessor();
    for (std::uint64_t i = 0; i < count / sizeof(float); ++i)
    {
      const float value = values[i];
      if (std::abs(value) < limit_)
      {
        const std::uint64_t point = offset / sizeof(float) + i;
        accessor.setValueOn({ static_cast<int>(point % row), static_cast<int>(point % slice / row),
                              static_cast<int>(point / slice) },
          value);
        signed_ = signed_ || value < 0.0F;
      }
    }
  }

  void close() override
  {
    if (signed_)
    {
      volume_->setGridClass(openvdb::GRID_LEVEL_SET);
      openvdb::tools::signedFloodFill(volume_->tree());
    }
    try
    {
      openvdb::io::File(file_).write({ volume_ });
    }
    catch (const openvdb::Exception& exception)
    {
      throw Failure(ExitCode::NoSpace, exception.what());
    }
  }

private:
  std::string file_;
  std::array<int, 3> dimensions_;
  float limit_;
  openvdb::FloatGrid::Ptr volume_;
  bool signed_ = false;
};

} // namespace

// C linkage gives it a name that can be asked for.
extern "C" __attribute__((visibility("default"))) ValueFile* makeVdbFile(const char* file,
  const Grid& grid, double band)
{
  static_assert(std::is_same_v<decltype(makeVdbFile), MakeVdbFile>);
  return new VdbFile(file, grid, band);
}

} // namespace medial::app
