#include "files/scans/scan_header.h"

#include "files/file_content.h"

#include <cmath>

namespace medial::files
{

ScanFrame makeFrame(const std::array<double, 3>& origin,
  const std::array<std::array<double, 3>, 3>& steps)
{
  ScanFrame frame{};
  for (std::size_t row = 0; row < 3; ++row)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      frame[row][axis] = steps[axis][row];
    }
    frame[row][3] = origin[row];
  }
  const double volume = voxelVolume(frame);
  if (!std::isfinite(volume) || volume == 0.0 || !std::isfinite(origin[0] + origin[1] + origin[2]))
  {
    refuseContent("its axes span no volume, or it is infinitely far away");
  }
  return frame;
}

double voxelVolume(const ScanFrame& frame)
{
  const ScanFrame& m = frame;
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

std::size_t ScanHeader::voxels() const
{
  constexpr double kMost = 1e12;
  double count = 1.0;
  for (const std::int64_t size : dimensions)
  {
    count *= static_cast<double>(size);
  }
  if (!(count >= 1.0 && count <= kMost))
  {
    refuseContent("has no voxels, or more than memory can have");
  }
  return static_cast<std::size_t>(count);
}

} // namespace medial::files
