#include "vtkMeshFieldInternals.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialEnumerations.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/error.h"

#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace
{

//------------------------------------------------------------------------------
void AddMesh(const medial::TriangleMesh& mesh, const medial::MeshConnectivity& connectivity,
  vtkMedialFigures& figures)
{
  figures.AddCount("Triangles", static_cast<vtkIdType>(mesh.triangles.size()));
  figures.AddCount("Vertices", static_cast<vtkIdType>(mesh.points.size()));
  figures.AddCount("Components", connectivity.components);
  figures.AddCount("DegenerateTriangles", mesh.degenerateTriangles);
  figures.AddFlag("Closed", connectivity.closed());
  figures.AddFlag("Manifold", connectivity.manifold());
  figures.AddFlag("Oriented", connectivity.oriented());
}

//------------------------------------------------------------------------------
void AddWork(const medial::RunStatistics& statistics, vtkMedialFigures& figures)
{
  figures.AddCount("Sites", statistics.sites);
  figures.AddCount("GroupTests", statistics.groupTests);
  figures.AddCount("SiteTests", statistics.siteTests);
  figures.AddCount("CandidatePairs", statistics.candidatePairs);
  figures.AddCount("Polygons", statistics.polygons);
  figures.AddCount("Fragments", statistics.fragments);
  figures.AddCount("Samples", statistics.samples);
  const medial::RunStatistics::Seconds& seconds = statistics.seconds;
  figures.AddParts("Seconds",
    { { "Sites", seconds.sites }, { "Sign", seconds.sign }, { "Cull", seconds.cull },
      { "Polygons", seconds.polygons }, { "Draw", seconds.draw }, { "Resolve", seconds.resolve },
      { "Medial", seconds.medial } });
}

//------------------------------------------------------------------------------
void AddDevice(const std::optional<medial::Device>& device, vtkMedialFigures& figures)
{
  if (device)
  {
    figures.AddText("Renderer", device->renderer);
    figures.AddText("RendererVersion", device->version);
    figures.AddFlag("SoftwareRenderer", device->software);
  }
}

} // namespace

//------------------------------------------------------------------------------
bool vtkMeshFieldAlgorithm::vtkInternals::Try(const std::function<void()>& work)
{
  return vtkRunGuarded(this->Self, this->Self->ErrorCode, work);
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::vtkInternals::Begin(vtkInformationVector* outputVector)
{
  for (int i = 0; i < outputVector->GetNumberOfInformationObjects(); ++i)
  {
    if (vtkImageData* image = vtkImageData::GetData(outputVector, i))
    {
      image->GetPointData()->Initialize();
    }
  }
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::vtkInternals::UpdateMesh(vtkPolyData* input,
  const medial::Execution& execution)
{
  if (!input)
  {
    throw medial::Error(medial::ErrorCode::InvalidInput, "the input is not a vtkPolyData");
  }
  if (input == this->MeshInput && input->GetMTime() == this->MeshTime)
  {
    return;
  }
  this->MeshInput = nullptr;
  this->Mesh = medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(input));
  this->Connectivity = medial::analyseConnectivity(this->Mesh, execution);
  this->MeshInput = input;
  this->MeshTime = input->GetMTime();
}

//------------------------------------------------------------------------------
medial::Grid vtkMeshFieldAlgorithm::vtkInternals::MakeGrid(vtkPolyData* input)
{
  if (this->Self->GridMode == EXPLICIT)
  {
    return this->MakeGrid(medial::Bounds{});
  }
  this->UpdateMesh(input);
  return this->MakeGrid(this->Mesh.bounds());
}

//------------------------------------------------------------------------------
medial::Grid vtkMeshFieldAlgorithm::vtkInternals::MakeGrid(const medial::Bounds& bounds)
{
  const vtkMeshFieldAlgorithm* self = this->Self;
  const medial::Point3 spacing = { self->Spacing[0], self->Spacing[1], self->Spacing[2] };
  switch (vtkMedialGridModes.ToLibrary(self->GridMode))
  {
    case RESOLUTION:
      return medial::makeGrid(bounds, self->Resolution, self->Padding);
    case SPACING:
      return medial::makeGridWithSpacing(bounds, spacing, self->Padding);
    case EXPLICIT:
      break;
  }
  const medial::Grid grid = { { self->Origin[0], self->Origin[1], self->Origin[2] }, spacing,
    { self->Dimensions[0], self->Dimensions[1], self->Dimensions[2] } };
  medial::validateGrid(grid);
  return grid;
}

//------------------------------------------------------------------------------
int vtkMeshFieldAlgorithm::vtkInternals::AnnounceImage(vtkInformationVector* outputVector, int port,
  const std::function<std::optional<medial::Grid>()>& makeGrid)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(port);
  const auto announce = [outInfo](const medial::Grid& grid)
  {
    int wholeExtent[6];
    vtkMeshConversion::ToVTKExtent(grid.wholeExtent(), wholeExtent);
    outInfo->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), wholeExtent, 6);
    outInfo->Set(vtkDataObject::ORIGIN(), grid.origin.data(), 3);
    outInfo->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
    vtkDataObject::SetActiveAttributeInfo(outInfo, vtkDataObject::FIELD_ASSOCIATION_POINTS,
      vtkDataSetAttributes::SCALARS, "Distance", VTK_FLOAT, 1, -1);
  };
  const bool done = this->Try(
    [&]
    {
      try
      {
        if (const std::optional<medial::Grid> grid = makeGrid())
        {
          announce(*grid);
        }
      }
      catch (...)
      {
        this->Refusal = std::current_exception();
        throw;
      }
    });
  if (!done)
  {
    announce(UnitGrid());
  }
  for (int i = 0; !done && i < outputVector->GetNumberOfInformationObjects(); ++i)
  {
    if (vtkDataObject* output = vtkDataObject::GetData(outputVector, i))
    {
      output->Initialize();
    }
  }
  return done ? 1 : 0;
}

//------------------------------------------------------------------------------
medial::Grid vtkMeshFieldAlgorithm::vtkInternals::UnitGrid()
{
  return { { 0.0, 0.0, 0.0 }, { 1.0, 1.0, 1.0 }, { 1, 1, 1 } };
}

//------------------------------------------------------------------------------
medial::Grid vtkMeshFieldAlgorithm::vtkInternals::AnnouncedGrid(vtkInformation* outInfo)
{
  medial::Grid grid;
  outInfo->Get(vtkDataObject::ORIGIN(), grid.origin.data());
  outInfo->Get(vtkDataObject::SPACING(), grid.spacing.data());
  const medial::Extent whole =
    vtkMeshConversion::ToExtent(outInfo->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT()));
  grid.dimensions = { whole.size(0), whole.size(1), whole.size(2) };
  return grid;
}

//------------------------------------------------------------------------------
medial::DistanceFieldOptions vtkMeshFieldAlgorithm::vtkInternals::MakeOptions(
  medial::Progress& progress)
{
  const vtkMeshFieldAlgorithm* self = this->Self;
  if (self->MemoryLimit != 0 && self->MemoryLimit < medial::kMinMemoryMiB)
  {
    vtkThrowBadParameter("MemoryLimit", self->MemoryLimit,
      "0 or >= " + std::to_string(medial::kMinMemoryMiB) + " (MiB)");
  }
  medial::DistanceFieldOptions options;
  options.sign = vtkMedialSignMethods.ToLibrary(self->SignMethod);
  options.engine = vtkMedialEngines.ToLibrary(self->Engine);
  options.device = self->Device;
  options.execution = vtkToExecution(self->NumberOfThreads, progress);
  options.memoryMiB = static_cast<std::size_t>(self->MemoryLimit);
  options.requireHardware = self->RequireHardware != 0;
  return options;
}

//------------------------------------------------------------------------------
vtkMeshConversion::ArraySelection vtkMeshFieldAlgorithm::vtkInternals::MakeSelection()
{
  vtkMeshConversion::ArraySelection selection;
  selection.ClosestPoint = this->Self->GenerateClosestPoint != 0;
  selection.ClosestCell = this->Self->GenerateClosestCell != 0;
  selection.ClosestFeature = this->Self->GenerateClosestFeature != 0;
  selection.ClosestSite = this->Self->GenerateClosestSite != 0;
  return selection;
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::vtkInternals::Record(const medial::Grid& grid,
  const medial::RunStatistics& statistics, vtkDataObject* output, bool withMesh)
{
  vtkMedialFigures figures(output);
  figures.AddText("SignMethod", vtkMedialSignMethods.NameOfLibrary(statistics.sign.method));
  figures.AddText("SignReason", statistics.sign.reason);
  figures.AddText("Engine", vtkMedialEngines.NameOfLibrary(statistics.engine));
  if (!statistics.note.empty())
  {
    figures.AddText("EngineNote", statistics.note);
  }
  figures.AddPoint("GridOrigin", grid.origin);
  figures.AddPoint("GridSpacing", grid.spacing);
  figures.AddCounts("GridDimensions", grid.dimensions);
  if (withMesh)
  {
    AddMesh(this->Mesh, this->Connectivity, figures);
  }
  AddWork(statistics, figures);
  AddDevice(statistics.device, figures);
}

//------------------------------------------------------------------------------
std::string vtkMeshFieldAlgorithm::vtkInternals::DescribeOptions()
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  const auto vector = [&text](const char* name, const auto* values)
  { text << name << ' ' << values[0] << ' ' << values[1] << ' ' << values[2] << '\n'; };
  vtkMeshFieldAlgorithm* filter = this->Self;
  text << "GridMode " << filter->GetGridModeAsString() << "\nResolution " << filter->GetResolution()
       << '\n';
  vector("Spacing", filter->GetSpacing());
  vector("Origin", filter->GetOrigin());
  vector("Dimensions", filter->GetDimensions());
  text << "Padding " << filter->GetPadding() << "\nSignMethod " << filter->GetSignMethodAsString()
       << "\nEngine " << filter->GetEngineAsString() << "\nGenerateClosestPoint "
       << filter->GetGenerateClosestPoint() << "\nGenerateClosestCell "
       << filter->GetGenerateClosestCell() << "\nGenerateClosestFeature "
       << filter->GetGenerateClosestFeature() << "\nGenerateClosestSite "
       << filter->GetGenerateClosestSite() << '\n';
  return text.str();
}
