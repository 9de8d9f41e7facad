#include "vtkMeshDistanceField.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/compute_distance_field.h"

vtkStandardNewMacro(vtkMeshDistanceField);

//------------------------------------------------------------------------------
vtkMeshDistanceField::vtkMeshDistanceField()
{
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkMeshDistanceField::~vtkMeshDistanceField() = default;

//------------------------------------------------------------------------------
vtkImageData* vtkMeshDistanceField::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkMeshDistanceField::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMeshDistanceField::RequestInformation(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  return this->RequestImageInformation(inputVector, outputVector, 0);
}

//------------------------------------------------------------------------------
int vtkMeshDistanceField::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const bool done = this->Internals->Try(
    [&]
    {
      vtkInternals::Begin(outputVector);
      const medial::Extent extent = vtkMeshConversion::ToExtent(
        outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
      if (extent.empty())
      {
        return;
      }
      vtkProgressBridge progress(this);
      const medial::DistanceFieldOptions options = this->Internals->MakeOptions(progress);
      this->Internals->UpdateMesh(vtkPolyData::GetData(inputVector[0]), options.execution);
      const medial::Grid grid = vtkInternals::AnnouncedGrid(outInfo);

      const medial::FieldArrays arrays =
        vtkMeshConversion::AllocateField(output, grid, extent, this->Internals->MakeSelection());
      const medial::RunStatistics statistics = medial::computeDistanceField(this->Internals->Mesh,
        this->Internals->Connectivity, grid, extent, arrays, options);
      this->Internals->Record(grid, statistics, output);
      vtkWarnOnce(this, statistics.note);
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMeshDistanceField::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
