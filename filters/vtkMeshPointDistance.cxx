#include "vtkMeshPointDistance.h"

#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialEnumerations.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialProgress.h"
#include "vtkMedialRequests.h"
#include "vtkMedialTimes.h"
#include "vtkMeshConversion.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkWeakPointer.h"

#include "medial/error.h"
#include "medial/point_distance.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkMeshPointDistance);

namespace
{

/// The share of the work that prepares a surface.
constexpr double PreparationShare = 0.3;

//------------------------------------------------------------------------------
std::vector<medial::Point3> PointsOf(vtkDataSet* data)
{
  std::vector<medial::Point3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

} // namespace

//------------------------------------------------------------------------------
/**
 * What was prepared, and for which surface.
 */
class vtkMeshPointDistance::vtkInternals
{
public:
  const medial::PointDistance& Prepare(vtkPolyData* surface, int signMethod,
    const medial::Execution& execution)
  {
    if (!this->Distance || this->Surface != surface || this->MTime != surface->GetMTime() ||
      this->SignMethod != signMethod)
    {
      this->Distance.reset();
      this->Distance = std::make_unique<medial::PointDistance>(
        medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(surface)),
        vtkMedialSignMethods.ToLibrary(signMethod), execution);
      this->Surface = surface;
      this->MTime = surface->GetMTime();
      this->SignMethod = signMethod;
    }
    return *this->Distance;
  }

private:
  std::unique_ptr<medial::PointDistance> Distance;
  vtkWeakPointer<vtkPolyData> Surface;
  vtkMTimeType MTime = 0;
  int SignMethod = 0;
};

//------------------------------------------------------------------------------
vtkMeshPointDistance::vtkMeshPointDistance()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
  vtkKeepTimes(this);
}

//------------------------------------------------------------------------------
vtkMeshPointDistance::~vtkMeshPointDistance() = default;

//------------------------------------------------------------------------------
void vtkMeshPointDistance::SetSurfaceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkMeshPointDistance::SetSurfaceData(vtkPolyData* surface)
{
  this->SetInputDataInternal(1, surface);
}

//------------------------------------------------------------------------------
const char* vtkMeshPointDistance::GetSignMethodAsString()
{
  return vtkMedialSignMethods.NameOf(this->SignMethod);
}

//------------------------------------------------------------------------------
int vtkMeshPointDistance::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataSet" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
// The superclass fails without a message where there are no points to copy the type of.
int vtkMeshPointDistance::RequestDataObject(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const bool hasPoints = vtkRunGuarded(this, this->ErrorCode,
    [&]
    {
      if (inputVector[0]->GetNumberOfInformationObjects() == 0)
      {
        throw medial::Error(medial::ErrorCode::InvalidInput,
          "input port 0, which takes the points, has no connection");
      }
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      if (!vtkDataSet::SafeDownCast(input))
      {
        throw medial::Error(medial::ErrorCode::InvalidInput,
          std::string("the input of port 0 is ") +
            (input ? std::string("a ") + input->GetClassName() : "missing") + ", not a vtkDataSet");
      }
    });
  return hasPoints ? this->Superclass::RequestDataObject(request, inputVector, outputVector) : 0;
}

//------------------------------------------------------------------------------
int vtkMeshPointDistance::RequestInformation(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkAnnounceTimes(inputVector, this->GetNumberOfInputPorts(), outputVector);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkMeshPointDistance::RequestUpdateExtent(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
  vtkRequestWhole(inputVector[1]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshPointDistance::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  // Assigned, since SetErrorCode() would modify the filter while it executes.
  this->ErrorCode = vtkErrorCode::NoError;
  const bool done = vtkRunGuarded(this, this->ErrorCode,
    [&]
    {
      vtkPolyData* surface = vtkPolyData::GetData(inputVector[1]);
      if (!surface)
      {
        throw medial::Error(medial::ErrorCode::InvalidInput,
          "the input of port 1 is not a vtkPolyData");
      }
      this->Execute(vtkDataSet::GetData(inputVector[0]), surface,
        vtkDataSet::GetData(outputVector));
      vtkMarkTime(outputVector->GetInformationObject(0), outputVector);
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMeshPointDistance::Execute(vtkDataSet* points, vtkPolyData* surface, vtkDataSet* output)
{
  vtkProgressBridge progress(this);
  vtkProgressPart preparation(progress, 0.0, PreparationShare);
  vtkProgressPart computation(progress, PreparationShare, 1.0);
  const medial::PointDistance& distance = this->Internals->Prepare(surface, this->SignMethod,
    vtkToExecution(this->NumberOfThreads, preparation));
  const medial::PointDistances result =
    distance.compute(PointsOf(points), vtkToExecution(this->NumberOfThreads, computation));
  output->ShallowCopy(points);
  vtkMeshConversion::AddDistances(result, output);
  const medial::DistanceSummary summary = medial::summarise(result);
  vtkMedialFigures figures(output);
  figures.AddText("SignMethod", vtkMedialSignMethods.NameOfLibrary(distance.sign().method));
  figures.AddText("SignReason", distance.sign().reason);
  figures.AddNumber("MinDistance", summary.min);
  figures.AddNumber("MaxDistance", summary.max);
  figures.AddNumber("MeanDistance", summary.mean);
  figures.AddNumber("RMSDistance", summary.rms);
  figures.AddNumber("MedianDistance", summary.median);
  figures.AddNumber("Percentile95Distance", summary.percentile95);
}

//------------------------------------------------------------------------------
void vtkMeshPointDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SignMethod: " << this->GetSignMethodAsString() << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
