// Parts of labels that are one voxel wide, which smoothing would close.
#include "files/scans/scan_surface.h"
#include "files/scans/thin_parts.h"

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include "vtkMeshConversion.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace medial::test
{
namespace
{

using files::Scan;
using files::ScanSurface;
using files::ThinParts;
using Voxel = ThinParts::Voxel;

// Voxels of a solid in a cube.
class Mask
{
public:
  static constexpr int kSize = 36;

  void fill(const Voxel& first, const Voxel& last, unsigned char value = 1)
  {
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int x = first[0]; x <= last[0]; ++x)
        {
          values_[(z * kSize + y) * kSize + x] = value;
        }
      }
    }
  }

  ThinParts parts() const { return { values_.data(), { kSize, kSize, kSize } }; }

  vtkSmartPointer<vtkPolyData> surface(int iterations) const
  {
    Scan scan;
    scan.frame = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } };
    scan.image = vtkSmartPointer<vtkImageData>::New();
    scan.image->SetDimensions(kSize, kSize, kSize);
    scan.image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    std::copy(values_.begin(), values_.end(),
      static_cast<unsigned char*>(scan.image->GetScalarPointer()));
    ScanSurface wanted;
    wanted.label = 1;
    wanted.smoothing = iterations;
    return extractSurface(scan, wanted, "a.nrrd");
  }

private:
  std::vector<unsigned char> values_ = std::vector<unsigned char>(kSize * kSize * kSize, 0);
};

double volumeOf(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(surface);
  return properties->GetVolume();
}

bool isClosed(vtkPolyData* surface)
{
  return analyseConnectivity(buildTriangleMesh(vtkMeshConversion::ToMeshInput(surface))).closed();
}

double smoothedVolume(const Mask& mask)
{
  const auto surface = mask.surface(ScanSurface::kOfLabels);
  EXPECT_TRUE(isClosed(surface));
  return volumeOf(surface);
}

} // namespace

TEST(ThinParts, AreBarsAndSheetsOfOneVoxelAndGapsInTheSolid)
{
  Mask mask;
  mask.fill({ 2, 2, 2 }, { 30, 2, 2 });
  mask.fill({ 2, 10, 2 }, { 30, 10, 30 });
  mask.fill({ 2, 20, 2 }, { 30, 30, 30 });
  mask.fill({ 5, 25, 5 }, { 25, 25, 25 }, 0);
  const ThinParts parts = mask.parts();
  for (const Voxel& thin : { Voxel{ 15, 2, 2 }, Voxel{ 2, 2, 2 }, Voxel{ 15, 10, 15 },
         Voxel{ 2, 10, 2 }, Voxel{ 15, 25, 15 }, Voxel{ 5, 25, 5 } })
  {
    EXPECT_TRUE(parts.contains(thin)) << thin[0] << ' ' << thin[1];
  }
  for (const Voxel& wide : { Voxel{ 15, 20, 15 }, Voxel{ 15, 24, 15 }, Voxel{ 15, 6, 6 },
         Voxel{ 0, 0, 0 }, Voxel{ -1, 35, 36 } })
  {
    EXPECT_FALSE(parts.contains(wide)) << wide[0] << ' ' << wide[1];
  }
}

TEST(ThinParts, AreNotTheStepsOfWideOnes)
{
  Mask mask;
  mask.fill({ 5, 5, 5 }, { 25, 25, 15 });
  mask.fill({ 8, 15, 16 }, { 20, 15, 16 });
  mask.fill({ 12, 8, 15 }, { 12, 12, 15 }, 0);
  EXPECT_FALSE(mask.parts().contains({ 12, 15, 16 }));
  EXPECT_FALSE(mask.parts().contains({ 12, 10, 15 }));
  // A bar that stands on the block is thin, down to its last voxel.
  mask.fill({ 20, 20, 16 }, { 20, 20, 20 });
  EXPECT_TRUE(mask.parts().contains({ 20, 20, 18 }));
  EXPECT_TRUE(mask.parts().contains({ 20, 20, 16 }));
  EXPECT_FALSE(mask.parts().contains({ 20, 20, 15 }));
}

// The surface of the steps around a bar is a prism over a square with the diagonal 1.
TEST(ThinParts, KeepTheirWidthWhenScansAreSmoothed)
{
  Mask bar;
  bar.fill({ 3, 3, 3 }, { 32, 3, 3 });
  EXPECT_NEAR(smoothedVolume(bar), 0.5 * 29.0, 0.3);
  Mask voxel;
  voxel.fill({ 3, 3, 3 }, { 3, 3, 3 });
  EXPECT_NEAR(smoothedVolume(voxel), 1.0 / 6.0, 1e-5); // an octahedron
  Mask sheet;
  sheet.fill({ 3, 3, 3 }, { 32, 3, 32 });
  EXPECT_NEAR(smoothedVolume(sheet), 29.0 * 29.0, 40.0);
}

TEST(ThinParts, LeaveTheOthersToSmoothing)
{
  Mask block;
  block.fill({ 5, 5, 5 }, { 20, 20, 20 });
  const double alone = smoothedVolume(block);
  EXPECT_GT(std::abs(alone - volumeOf(block.surface(0))), 1.0);
  block.fill({ 30, 3, 3 }, { 30, 3, 32 });
  EXPECT_NEAR(smoothedVolume(block), alone + 0.5 * 29.0, 0.3);
}

} // namespace medial::test
