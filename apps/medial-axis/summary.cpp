#include "summary.h"

#include "text_cursor.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <cstdio>
#include <string>

namespace medial::app
{
namespace
{

void printMesh(const Options& options, vtkMedialAxis* filter)
{
  std::printf("mesh      %s: %lld triangles, %lld vertices, %lld component%s, %s\n",
    options.input.c_str(), static_cast<long long>(filter->GetNumberOfTriangles()),
    static_cast<long long>(filter->GetNumberOfVertices()),
    static_cast<long long>(filter->GetNumberOfComponents()),
    filter->GetNumberOfComponents() == 1 ? "" : "s", filter->GetClosed() ? "closed" : "not closed");
}

void printGrid(vtkMedialAxis* filter)
{
  int dimensions[3];
  double spacing[3];
  filter->GetUsedDimensions(dimensions);
  filter->GetUsedSpacing(spacing);
  std::printf("grid      %d x %d x %d points, spacing %.4g, sign: %s\n", dimensions[0],
    dimensions[1], dimensions[2], spacing[0],
    lowerCase(filter->GetUsedSignMethodAsString()).c_str());
}

void printSeconds(vtkMedialAxis* filter, const AppSeconds& seconds)
{
  std::printf("seconds   read %.2f, sites %.2f, cull %.2f, polygons %.2f, draw %.2f, resolve %.2f, "
              "medial %.2f, write %.2f, total %.2f\n",
    seconds.read, filter->GetSitesSeconds(), filter->GetCullSeconds(), filter->GetPolygonsSeconds(),
    filter->GetDrawSeconds(), filter->GetResolveSeconds(), filter->GetMedialSeconds(),
    seconds.write, seconds.total);
}

void printFile(const std::filesystem::path& path, const std::string& content)
{
  if (!path.empty())
  {
    std::printf("wrote     %s: %s\n", path.c_str(), content.c_str());
  }
}

void printOutputs(const Options& options, vtkMedialAxis* filter)
{
  vtkPolyData* axis = filter->GetOutput();
  printFile(options.output,
    "medial axis, " + std::to_string(axis->GetNumberOfPoints()) + " points, " +
      std::to_string(axis->GetNumberOfCells()) + " cells");
  printFile(options.field, "distance field");
  printFile(options.image, "picture of axis and surface");
  printFile(options.report, "report of the run");
}

const char* whyUnsigned(const Options& options, vtkMedialAxis* filter)
{
  if (options.signMethod == vtkMedialAxis::SIGN_NONE)
  {
    return "sign method none";
  }
  return filter->GetClosed() ? "the mesh is not consistently oriented" : "the mesh is not closed";
}

void printNotes(const Options& options, vtkMedialAxis* filter)
{
  if (filter->GetUsedSide() != options.side)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: the distance is unsigned (%s), so the axis is that of both sides\n",
      options.input.c_str(), whyUnsigned(options, filter));
  }
  if (filter->GetOutput()->GetNumberOfPoints() == 0)
  {
    std::fprintf(stderr,
      "medial-axis: note: %s: no point of the grid has a separation angle of %g degrees or more\n",
      options.input.c_str(), options.angle);
  }
}

} // namespace

void printSummary(const Options& options, vtkMedialAxis* filter, const AppSeconds& seconds)
{
  printNotes(options, filter);
  printMesh(options, filter);
  printGrid(filter);
  std::printf("renderer  %s%s\n", filter->GetRenderer(),
    filter->GetSoftwareRenderer() ? " (software)" : "");
  printSeconds(filter, seconds);
  printOutputs(options, filter);
}

} // namespace medial::app
