#include "output_writer.h"

#include "output/file_writer.h"
#include "output/vtp_writer.h"
#include "pictures/histogram_picture.h"
#include "pictures/picture.h"
#include "pictures/picture_caption.h"
#include "pictures/thickness_picture.h"
#include "region_table.h"
#include "skeleton_table.h"
#include "surface_thickness.h"
#include "timer.h"
#include "vtk_messages.h"
#include "web/html_page.h"

#include "medial/axis_io.h"

#include <vtkErrorCode.h>
#include <vtkMedialCurves.h>
#include <vtkMeshConversion.h>
#include <vtkMeshFieldAlgorithm.h>
#include <vtkNew.h>

#include <algorithm>
#include <new>
#include <optional>
#include <stdexcept>

namespace medial::app
{
namespace
{

// The axis for those outputs that VTK makes; null if there are none.
vtkSmartPointer<vtkPolyData> axisForVtk(const Options& options, const MedialAxis& axis)
{
  const bool isVtp = !options.output.empty() && !axisFormatOf(options.output);
  if (!isVtp && options.curves.empty() && options.image.empty() && options.html.empty())
  {
    return nullptr;
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkMeshConversion::ToPolyData(axis, polyData);
  return polyData;
}

void writeAxisFile(const MedialAxis& axis, vtkPolyData* polyData, const Options& options,
  const std::filesystem::path& file)
{
  if (const auto format = axisFormatOf(options.output))
  {
    writeFile(file, [&](std::ostream& stream) { writeAxis(axis, *format, stream); });
    return;
  }
  writeVtp(polyData, file);
}

// Returns the number of curves.
long long writeCurves(vtkPolyData* axis, const std::filesystem::path& file)
{
  const VtkMessages messages;
  vtkNew<vtkMedialCurves> curves;
  curves->SetInputData(axis);
  curves->Update();
  if (curves->GetErrorCode() == vtkMeshFieldAlgorithm::OutOfMemoryError)
  {
    throw std::bad_alloc();
  }
  if (curves->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error(messages.first());
  }
  writeVtp(curves->GetOutput(), file);
  return curves->GetOutput()->GetNumberOfLines();
}

// The skeleton for VTK; null if there is none.
vtkSmartPointer<vtkPolyData> skeletonForVtk(const std::optional<Skeleton>& skeleton)
{
  if (!skeleton)
  {
    return nullptr;
  }
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkMeshConversion::ToPolyData(*skeleton, polyData);
  return polyData;
}

PictureRegions pictureRegions(const Result& result)
{
  PictureRegions regions;
  if (!result.regions.empty())
  {
    regions.triangles = regionsOf(result);
  }
  for (std::size_t i = 0; i < std::min(kListedRegions, result.regions.size()); ++i)
  {
    const ThicknessRegion& region = result.regions[i];
    regions.first.push_back({ region.place, outwardNormal(region, result) });
  }
  return regions;
}

} // namespace

OutputNotes writeOutputs(const Options& options, Surface& surface, const Result& result,
  Outputs& outputs)
{
  OutputNotes notes;
  const vtkSmartPointer<vtkPolyData> axis = axisForVtk(options, result.axis);
  outputs.write(options.output,
    [&](const auto& file) { writeAxisFile(result.axis, axis, options, file); });
  outputs.write(options.curves, [&](const auto& file) { notes.curves = writeCurves(axis, file); });
  const vtkSmartPointer<vtkPolyData> skeleton = skeletonForVtk(result.skeleton);
  outputs.write(options.skeleton, [&](const auto& file) { writeVtp(skeleton, file); });
  outputs.write(options.skeletonTable,
    [&](const auto& file) {
      writeFile(file, [&](std::ostream& stream) { writeSkeletonTable(*result.skeleton, stream); });
    });
  const Timer axisPicture;
  outputs.write(options.image,
    [&](const auto& file)
    {
      if (skeleton != nullptr)
      {
        drawSkeleton(surface.polyData(), skeleton, axisCaption(options, result), file);
      }
      else
      {
        drawPicture(surface.polyData(), axis, axisCaption(options, result), file);
      }
    });
  notes.pictureSeconds = axisPicture.seconds();
  outputs.write(options.html,
    [&](const auto& file)
    {
      notes.page =
        writeHtml(result.mesh, axis, skeleton, axisCaption(options, result), options.angle, file);
    });
  outputs.write(options.thickness,
    [&](const auto& file) { writeVtp(result.thicknessSurface, file); });
  outputs.write(options.thinRegions, [&](const auto& file) { writeVtp(regionsOf(result), file); });
  const Timer otherPictures;
  outputs.write(options.histogram,
    [&](const auto& file)
    { drawHistogram(*result.localThickness, localThicknessCaption(options, result), file); });
  outputs.write(options.thicknessImage,
    [&](const auto& file)
    {
      drawThickness(result.thicknessPicture, surface.polyData(), pictureRegions(result),
        thicknessCaption(options, result), file);
    });
  notes.pictureSeconds += otherPictures.seconds();
  return notes;
}

} // namespace medial::app
