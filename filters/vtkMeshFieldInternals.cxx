#include "vtkMeshFieldInternals.h"

#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#include <exception>
#include <new>
#include <sstream>

// From here on executives keep filters downstream from using an output that a filter gave up,
// without an error message of their own, and leave it to filters to reset AbortExecute.
#define MEDIAL_VTK_ABORTS_OUTPUTS (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20221101))

namespace
{

constexpr int MinMemoryLimit = 64;

//------------------------------------------------------------------------------
medial::SignMethod ToSignMethod(int method)
{
  switch (method)
  {
    case vtkMeshFieldAlgorithm::SIGN_AUTO:
      return medial::SignMethod::Auto;
    case vtkMeshFieldAlgorithm::SIGN_NONE:
      return medial::SignMethod::None;
    case vtkMeshFieldAlgorithm::SIGN_PSEUDONORMAL:
      return medial::SignMethod::Pseudonormal;
    case vtkMeshFieldAlgorithm::SIGN_WINDING:
      return medial::SignMethod::Winding;
    default:
      vtkThrowBadParameter("SignMethod", method,
        "one of 0 (auto), 1 (none), 2 (pseudonormal), "
        "3 (winding)");
  }
}

//------------------------------------------------------------------------------
medial::Engine ToEngine(int engine)
{
  switch (engine)
  {
    case vtkMeshFieldAlgorithm::ENGINE_AUTO:
      return medial::Engine::Auto;
    case vtkMeshFieldAlgorithm::ENGINE_RASTERISER:
      return medial::Engine::Rasteriser;
    case vtkMeshFieldAlgorithm::ENGINE_PROCESSOR:
      return medial::Engine::Processor;
    default:
      vtkThrowBadParameter("Engine", engine, "one of 0 (auto), 1 (rasteriser), 2 (processor)");
  }
}

//------------------------------------------------------------------------------
unsigned long ToErrorCode(medial::ErrorCode code)
{
  switch (code)
  {
    case medial::ErrorCode::InvalidInput:
      return vtkMeshFieldAlgorithm::InvalidInputError;
    case medial::ErrorCode::NoGpu:
      return vtkMeshFieldAlgorithm::NoGpuError;
    case medial::ErrorCode::ShaderBuild:
      return vtkMeshFieldAlgorithm::ShaderBuildError;
    case medial::ErrorCode::GpuLimit:
      return vtkMeshFieldAlgorithm::GpuLimitError;
    case medial::ErrorCode::OutOfMemory:
      return vtkMeshFieldAlgorithm::OutOfMemoryError;
    case medial::ErrorCode::Cancelled:
      return vtkMeshFieldAlgorithm::CancelledError;
  }
  return vtkMeshFieldAlgorithm::InternalError;
}

} // namespace

//------------------------------------------------------------------------------
bool vtkRunGuarded(vtkAlgorithm* algorithm, unsigned long& errorCode,
  const std::function<void()>& work)
{
  const auto fail = [&](unsigned long code, const char* message)
  {
    errorCode = code;
    vtkErrorWithObjectMacro(algorithm, << message);
  };
  errorCode = vtkErrorCode::NoError;
  try
  {
    work();
  }
  catch (const medial::Error& error)
  {
    if (error.code() == medial::ErrorCode::Cancelled)
    {
      errorCode = vtkMeshFieldAlgorithm::CancelledError;
    }
    else
    {
      fail(ToErrorCode(error.code()), error.what());
    }
  }
  catch (const std::bad_alloc&)
  {
    fail(vtkMeshFieldAlgorithm::OutOfMemoryError, "not enough memory for the result");
  }
  catch (const std::exception& error)
  {
    fail(vtkMeshFieldAlgorithm::InternalError, error.what());
  }
  return errorCode == vtkErrorCode::NoError;
}

//------------------------------------------------------------------------------
// Data released and not generated is what makes the pipeline execute again on the next update.
int vtkEndWithoutOutput([[maybe_unused]] vtkAlgorithm* algorithm,
  vtkInformationVector* outputVector)
{
  for (int i = 0; i < outputVector->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = outputVector->GetInformationObject(i);
    if (vtkDataObject* output = vtkDataObject::GetData(info))
    {
      output->ReleaseData();
      info->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    }
    // To the extent of a request that fails VTK adds that of the next, which may be of a smaller
    // grid.
    info->Remove(vtkStreamingDemandDrivenPipeline::COMBINED_UPDATE_EXTENT());
  }
#if MEDIAL_VTK_ABORTS_OUTPUTS
  algorithm->SetAbortOutput(true);
  return 1;
#else
  return 0;
#endif
}

//------------------------------------------------------------------------------
void vtkThrowBadParameter(const char* name, int value, const char* range)
{
  std::ostringstream message;
  message << name << ' ' << value << " is not " << range;
  throw medial::Error(medial::ErrorCode::InvalidInput, message.str());
}

//------------------------------------------------------------------------------
void vtkRequestWhole(vtkInformation* request)
{
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
bool vtkMeshFieldAlgorithm::vtkInternals::Try(const std::function<void()>& work)
{
  if (!vtkRunGuarded(this->Self, this->Self->ErrorCode, work))
  {
    this->Last = Outcome();
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::vtkInternals::Begin(vtkInformationVector* outputVector)
{
  this->Last = Outcome();
  for (int i = 0; i < outputVector->GetNumberOfInformationObjects(); ++i)
  {
    if (vtkImageData* image = vtkImageData::GetData(outputVector, i))
    {
      image->GetPointData()->Initialize();
    }
  }
}

//------------------------------------------------------------------------------
void vtkMeshFieldAlgorithm::vtkInternals::UpdateMesh(vtkPolyData* input)
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
  this->Connectivity = medial::analyseConnectivity(this->Mesh);
  this->MeshInput = input;
  this->MeshTime = input->GetMTime();
}

//------------------------------------------------------------------------------
medial::Grid vtkMeshFieldAlgorithm::vtkInternals::MakeGrid(vtkPolyData* input)
{
  const vtkMeshFieldAlgorithm* self = this->Self;
  const medial::Point3 spacing = { self->Spacing[0], self->Spacing[1], self->Spacing[2] };
  if (self->GridMode == EXPLICIT)
  {
    const medial::Grid grid = { { self->Origin[0], self->Origin[1], self->Origin[2] }, spacing,
      { self->Dimensions[0], self->Dimensions[1], self->Dimensions[2] } };
    medial::validateGrid(grid);
    return grid;
  }
  this->UpdateMesh(input);
  switch (self->GridMode)
  {
    case RESOLUTION:
      return medial::makeGrid(this->Mesh.bounds(), self->Resolution, self->Padding);
    case SPACING:
      return medial::makeGridWithSpacing(this->Mesh.bounds(), spacing, self->Padding);
    default:
      vtkThrowBadParameter("GridMode", self->GridMode,
        "one of 0 (resolution), 1 (spacing), 2 (explicit)");
  }
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
  medial::Progress* progress)
{
  const vtkMeshFieldAlgorithm* self = this->Self;
  if (self->NumberOfThreads < 0)
  {
    vtkThrowBadParameter("NumberOfThreads", self->NumberOfThreads, ">= 0");
  }
  if (self->MemoryLimit != 0 && self->MemoryLimit < MinMemoryLimit)
  {
    vtkThrowBadParameter("MemoryLimit", self->MemoryLimit, "0 or >= 64 (MiB)");
  }
  medial::DistanceFieldOptions options;
  options.sign = ToSignMethod(self->SignMethod);
  options.engine = ToEngine(self->Engine);
  options.execution.threads = self->NumberOfThreads;
  options.memoryMiB = static_cast<std::size_t>(self->MemoryLimit);
  options.requireHardware = self->RequireHardware != 0;
  options.execution.progress = progress;
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
void vtkMeshFieldAlgorithm::vtkInternals::Record(const medial::Grid& grid, medial::SignMethod sign,
  const medial::RunStatistics& statistics)
{
  this->Last.Grid = grid;
  this->Last.Sign = sign;
  this->Last.Statistics = statistics;
  this->Last.NumberOfTriangles = static_cast<vtkIdType>(this->Mesh.triangles.size());
  this->Last.NumberOfVertices = static_cast<vtkIdType>(this->Mesh.points.size());
  this->Last.NumberOfComponents = this->Connectivity.components;
  this->Last.NumberOfDegenerateTriangles = this->Mesh.degenerateTriangles;
  this->Last.Closed = this->Connectivity.closed();
  this->Last.Manifold = this->Connectivity.manifold();
  this->Last.Oriented = this->Connectivity.oriented();
}

//------------------------------------------------------------------------------
vtkProgressBridge::vtkProgressBridge(vtkAlgorithm* algorithm)
  : Algorithm(algorithm)
{
#if MEDIAL_VTK_ABORTS_OUTPUTS
  algorithm->AbortExecute = 0;
#endif
}

//------------------------------------------------------------------------------
void vtkProgressBridge::report(double fraction, const char* phase)
{
  this->Algorithm->SetProgressText(phase);
  this->Algorithm->UpdateProgress(fraction);
}

//------------------------------------------------------------------------------
bool vtkProgressBridge::cancelled()
{
  return this->Algorithm->GetAbortExecute() != 0;
}
