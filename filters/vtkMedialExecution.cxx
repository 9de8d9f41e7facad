#include "vtkMedialExecution.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialAxis.h"
#include "vtkMeshFieldAlgorithm.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVersionMacros.h"

#include "medial/error.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <mutex>
#include <new>
#include <set>
#include <sstream>

// From this version on executives keep filters downstream from using the output of an aborted
// filter, without an error message of their own, and leave it to filters to reset AbortExecute.
#define MEDIAL_VTK_ABORTS_OUTPUTS (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20221101))

namespace
{

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
    case medial::ErrorCode::CannotRead:
    case medial::ErrorCode::CannotWrite:
      break; // filters touch no files
  }
  return vtkMeshFieldAlgorithm::InternalError;
}

//------------------------------------------------------------------------------
// While GlobalWarningDisplay is off the macro does not even tell observers, whom Python's
// exceptions depend on. They get the text in the macro's form.
void ReportError(vtkAlgorithm* algorithm, const char* message)
{
  if (vtkObject::GetGlobalWarningDisplay())
  {
    vtkErrorWithObjectMacro(algorithm, << message);
  }
  else if (algorithm->HasObserver(vtkCommand::ErrorEvent))
  {
    std::ostringstream text;
    text << "ERROR: In " << __FILE__ << ", line " << __LINE__ << "\n"
         << algorithm->GetClassName() << " (" << algorithm << "): " << message << "\n\n";
    std::string characters = text.str();
    algorithm->InvokeEvent(vtkCommand::ErrorEvent, characters.data());
  }
}

} // namespace

//------------------------------------------------------------------------------
bool vtkRunGuarded(vtkAlgorithm* algorithm, unsigned long& errorCode,
  const std::function<void()>& work)
{
  const auto fail = [&](unsigned long code, const char* message)
  {
    errorCode = code;
    ReportError(algorithm, message);
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
void vtkWarnOnce(vtkAlgorithm* algorithm, const std::string& note)
{
  static std::mutex mutex;
  static std::set<std::string> known;
  std::string cause = note;
  cause.erase(std::remove_if(cause.begin(), cause.end(),
                [](unsigned char c) { return std::isdigit(c) != 0; }),
    cause.end());
  const auto isNew = [&]
  {
    const std::lock_guard<std::mutex> lock(mutex);
    return known.insert(cause).second;
  };
  if (!note.empty() && vtkObject::GetGlobalWarningDisplay() && isNew())
  {
    vtkWarningWithObjectMacro(algorithm, << note);
  }
}

//------------------------------------------------------------------------------
// Data that are released and not marked as generated make the pipeline execute again on the next
// update.
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
    // VTK merges the extent of a request that failed with that of the next one, whose grid may be
    // smaller.
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
medial::Execution vtkToExecution(int numberOfThreads, medial::Progress& progress)
{
  if (numberOfThreads < 0)
  {
    vtkThrowBadParameter("NumberOfThreads", numberOfThreads, ">= 0");
  }
  return { numberOfThreads, &progress };
}

//------------------------------------------------------------------------------
medial::Side vtkToSide(int side)
{
  switch (side)
  {
    case vtkMedialAxis::INTERIOR:
      return medial::Side::Interior;
    case vtkMedialAxis::EXTERIOR:
      return medial::Side::Exterior;
    case vtkMedialAxis::BOTH:
      return medial::Side::Both;
    default:
      vtkThrowBadParameter("Side", side, "one of 0 (interior), 1 (exterior), 2 (both)");
  }
}

//------------------------------------------------------------------------------
const char* vtkSideAsString(int side)
{
  switch (side)
  {
    case vtkMedialAxis::INTERIOR:
      return "Interior";
    case vtkMedialAxis::EXTERIOR:
      return "Exterior";
    case vtkMedialAxis::BOTH:
      return "Both";
    default:
      return "Unknown";
  }
}

//------------------------------------------------------------------------------
int vtkFromSide(medial::Side side)
{
  switch (side)
  {
    case medial::Side::Interior:
      return vtkMedialAxis::INTERIOR;
    case medial::Side::Exterior:
      return vtkMedialAxis::EXTERIOR;
    case medial::Side::Both:
      break;
  }
  return vtkMedialAxis::BOTH;
}

//------------------------------------------------------------------------------
medial::SignMethod vtkToSignMethod(int method)
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
        "one of 0 (auto), 1 (none), 2 (pseudonormal), 3 (winding)");
  }
}

//------------------------------------------------------------------------------
const char* vtkSignMethodAsString(int method)
{
  switch (method)
  {
    case vtkMeshFieldAlgorithm::SIGN_AUTO:
      return "Auto";
    case vtkMeshFieldAlgorithm::SIGN_NONE:
      return "None";
    case vtkMeshFieldAlgorithm::SIGN_PSEUDONORMAL:
      return "Pseudonormal";
    case vtkMeshFieldAlgorithm::SIGN_WINDING:
      return "Winding";
    default:
      return "Unknown";
  }
}

//------------------------------------------------------------------------------
int vtkFromSignMethod(medial::SignMethod method)
{
  switch (method)
  {
    case medial::SignMethod::None:
      return vtkMeshFieldAlgorithm::SIGN_NONE;
    case medial::SignMethod::Pseudonormal:
      return vtkMeshFieldAlgorithm::SIGN_PSEUDONORMAL;
    case medial::SignMethod::Winding:
      return vtkMeshFieldAlgorithm::SIGN_WINDING;
    case medial::SignMethod::Auto:
      break;
  }
  return vtkMeshFieldAlgorithm::SIGN_AUTO;
}

//------------------------------------------------------------------------------
void vtkAcceptSurface(vtkInformation* port, bool inPieces)
{
  vtkInformationStringVectorKey* types = vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE();
  port->Remove(types);
  port->Append(types, "vtkPolyData");
  if (inPieces)
  {
    port->Append(types, "vtkUnstructuredGrid");
    port->Append(types, "vtkCompositeDataSet");
  }
}

//------------------------------------------------------------------------------
void vtkRequestWhole(vtkInformation* request)
{
  vtkRequestPiece(request, 0, 1);
}

//------------------------------------------------------------------------------
void vtkRequestPiece(vtkInformation* request, int piece, int pieces)
{
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), piece);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), pieces);
  request->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

//------------------------------------------------------------------------------
bool vtkUpdateInput(vtkAlgorithm* algorithm, int piece, int pieces)
{
  int port = 0;
  vtkAlgorithm* producer = algorithm->GetInputAlgorithm(0, 0, port);
  vtkNew<vtkInformationVector> requests;
  requests->SetNumberOfInformationObjects(producer->GetNumberOfOutputPorts());
  vtkRequestPiece(requests->GetInformationObject(port), piece, pieces);
  return producer->Update(port, requests) != 0;
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

//------------------------------------------------------------------------------
void vtkProgressBridge::ReportOrStop(double fraction, const char* phase)
{
  this->report(fraction, phase);
  if (this->cancelled())
  {
    throw medial::Error(medial::ErrorCode::Cancelled, "cancelled");
  }
}

//------------------------------------------------------------------------------
void vtkProgressPart::report(double fraction, const char* phase)
{
  this->Bridge.report(this->From + fraction * (this->To - this->From), phase);
}
