#include "labelled_ball.h"

#include "support/files.h"

#include "medial/mesh_connectivity.h"
#include "medial/triangle_mesh.h"

#include "vtkMeshConversion.h"

#include <vtkCellArray.h>

#include <cmath>

namespace medial::test
{

using files::Scan;
using files::ScanSurface;

LabelImage ball(bool mirrored)
{
  return LabelImage([](double r) { return r < kRadius ? kLabel : r < 5.0 ? 7 : 0; }, mirrored);
}

ScanSurface ofLabel(long long label)
{
  ScanSurface wanted;
  wanted.label = label;
  return wanted;
}

ScanSurface ofValue(double value)
{
  ScanSurface wanted;
  wanted.isovalue = value;
  return wanted;
}

Scan readText(const std::string& name, const std::string& content)
{
  const TemporaryFolder folder;
  writeFile(folder.file(name), content);
  return files::readScan(folder.file(name));
}

double distanceToCentre(const double* point)
{
  return std::hypot(point[0] - kImageCentre[0], point[1] - kImageCentre[1],
    point[2] - kImageCentre[2]);
}

double volumeOf(vtkPolyData* surface)
{
  double sum = 0.0;
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  for (surface->GetPolys()->InitTraversal(); surface->GetPolys()->GetNextCell(count, ids) != 0;)
  {
    double corner[3][3];
    for (int k = 0; k < 3; ++k)
    {
      surface->GetPoint(ids[k], corner[k]);
      for (int axis = 0; axis < 3; ++axis)
      {
        corner[k][axis] -= kImageCentre[axis];
      }
    }
    const auto& [a, b, c] = corner;
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
      a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6.0;
}

bool isClosed(vtkPolyData* surface)
{
  return analyseConnectivity(buildTriangleMesh(vtkMeshConversion::ToMeshInput(surface))).closed();
}

} // namespace medial::test
