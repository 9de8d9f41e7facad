#include "vtkMedialExecution.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMeshFieldAlgorithm.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/error.h"

#include <algorithm>
#include <cctype>
#include <exception>
#include <mutex>
#include <new>
#include <set>
#include <sstream>

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
void vtkThrowBadParameter(const char* name, int value, const std::string& range)
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
