#include "vtkMedialTimes.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleKey.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <set>
#include <vector>

namespace
{

//------------------------------------------------------------------------------
// Takes the time of the first block; all blocks are of the same time.
void TakeTimeOfBlocks(vtkCompositeDataSet* output)
{
  if (output)
  {
    const vtkSmartPointer<vtkCompositeDataIterator> block =
      vtkSmartPointer<vtkCompositeDataIterator>::Take(output->NewIterator());
    if (!block->IsDoneWithTraversal())
    {
      output->GetInformation()->CopyEntry(block->GetCurrentDataObject()->GetInformation(),
        vtkDataObject::DATA_TIME_STEP());
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkAnnounceTimes(vtkInformationVector** inputVector, int ports,
  vtkInformationVector* outputVector)
{
  vtkInformationDoubleVectorKey* const stepsKey = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  vtkInformationDoubleVectorKey* const rangeKey = vtkStreamingDemandDrivenPipeline::TIME_RANGE();
  std::set<double> steps;
  std::set<double> ends;
  for (int port = 0; port < ports; ++port)
  {
    for (int i = 0; i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputVector[port]->GetInformationObject(i);
      const double* ofSteps = info->Get(stepsKey);
      const double* ofRange = info->Get(rangeKey);
      steps.insert(ofSteps, ofSteps + info->Length(stepsKey));
      ends.insert(ofRange, ofRange + info->Length(rangeKey));
    }
  }
  const std::vector<double> sorted(steps.begin(), steps.end());
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Remove(stepsKey);
    info->Remove(rangeKey);
    if (!sorted.empty())
    {
      info->Set(stepsKey, sorted.data(), static_cast<int>(sorted.size()));
    }
    if (!ends.empty())
    {
      const double range[] = { *ends.begin(), *ends.rbegin() };
      info->Set(rangeKey, range, 2);
    }
  }
}

//------------------------------------------------------------------------------
void vtkMarkTime(vtkInformation* requested, vtkInformationVector* outputVector)
{
  vtkInformationDoubleKey* const timeKey = vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP();
  for (int port = 0;
       requested->Has(timeKey) && port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputVector, port);
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), requested->Get(timeKey));
  }
}

//------------------------------------------------------------------------------
void vtkKeepTimes(vtkAlgorithm* algorithm)
{
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      vtkExecutive* executive = static_cast<vtkAlgorithm*>(caller)->GetExecutive();
      vtkInformationVector* outputs = executive->GetOutputInformation();
      vtkAnnounceTimes(executive->GetInputInformation(), executive->GetNumberOfInputPorts(),
        outputs);
      for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
      {
        TakeTimeOfBlocks(vtkCompositeDataSet::GetData(outputs, port));
      }
    });
  algorithm->AddObserver(vtkCommand::EndEvent, command);
}
