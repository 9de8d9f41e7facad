#include "vtkMedialPolyDataAlgorithm.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkMedialRequests.h"
#include "vtkMedialTimes.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/error.h"

#include <algorithm>
#include <string>

namespace
{

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> InputsOf(vtkInformationVector** inputVector, int ports)
{
  std::vector<vtkPolyData*> inputs;
  for (int port = 0; port < ports; ++port)
  {
    inputs.push_back(vtkPolyData::GetData(inputVector[port]));
    if (!inputs.back())
    {
      throw medial::Error(medial::ErrorCode::InvalidInput,
        "the input of port " + std::to_string(port) + " is not a vtkPolyData");
    }
  }
  return inputs;
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialPolyDataAlgorithm::vtkMedialPolyDataAlgorithm() = default;

//------------------------------------------------------------------------------
vtkMedialPolyDataAlgorithm::~vtkMedialPolyDataAlgorithm() = default;

//------------------------------------------------------------------------------
int vtkMedialPolyDataAlgorithm::RequestInformation(vtkInformation*,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkAnnounceTimes(inputVector, this->GetNumberOfInputPorts(), outputVector);
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    outputVector->GetInformationObject(port)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialPolyDataAlgorithm::RequestUpdateExtent(vtkInformation*,
  vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    vtkRequestWhole(inputVector[port]->GetInformationObject(0));
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialPolyDataAlgorithm::RequestData(vtkInformation* request,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int port = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  vtkInformation* outInfo = outputVector->GetInformationObject(port);
  // Assigned, since SetErrorCode() would modify the filter while it executes.
  this->ErrorCode = vtkErrorCode::NoError;
  if (outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1;
  }
  const bool done = vtkRunGuarded(this, this->ErrorCode,
    [&]
    {
      std::vector<vtkPolyData*> outputs;
      for (int i = 0; i < this->GetNumberOfOutputPorts(); ++i)
      {
        outputs.push_back(vtkPolyData::GetData(outputVector, i));
      }
      this->Execute(InputsOf(inputVector, this->GetNumberOfInputPorts()), outputs);
      vtkMarkTime(outInfo, outputVector);
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialPolyDataAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
