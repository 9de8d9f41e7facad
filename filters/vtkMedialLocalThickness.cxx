#include "vtkMedialLocalThickness.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialEnumerations.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialProgress.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/local_thickness.h"

#include <optional>
#include <string>

vtkStandardNewMacro(vtkMedialLocalThickness);

namespace
{

constexpr const char* ArrayName = "LocalThickness";

//------------------------------------------------------------------------------
// Lays out the image, still without values; returns where the library writes them.
float* Allocate(vtkImageData* output, const medial::Grid& grid)
{
  const medial::FieldArrays arrays = vtkMeshConversion::AllocateField(output, grid,
    grid.wholeExtent(), { false, false, false, false });
  output->GetPointData()->GetScalars()->SetName(ArrayName);
  return arrays.distance;
}

//------------------------------------------------------------------------------
void Record(const std::optional<medial::LocalThicknessSummary>& summary, const std::string& name,
  vtkDataObject* output)
{
  if (!summary)
  {
    return;
  }
  vtkMedialFigures(output).AddParts((name + "Distribution").c_str(),
    { { "Points", static_cast<double>(summary->points) }, { "Minimum", summary->min },
      { "Mean", summary->mean }, { "StandardDeviation", summary->standardDeviation },
      { "Maximum", summary->max }, { "HistogramEnd", summary->end } });
  vtkNew<vtkIdTypeArray> histogram;
  histogram->SetName((name + "Histogram").c_str());
  for (const std::int64_t count : summary->histogram)
  {
    histogram->InsertNextValue(static_cast<vtkIdType>(count));
  }
  output->GetFieldData()->AddArray(histogram);
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialLocalThickness::vtkMedialLocalThickness()
{
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkMedialLocalThickness::~vtkMedialLocalThickness() = default;

//------------------------------------------------------------------------------
vtkImageData* vtkMedialLocalThickness::GetOutput()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
const char* vtkMedialLocalThickness::GetSideAsString()
{
  return vtkMedialSides.NameOf(this->Side);
}

//------------------------------------------------------------------------------
int vtkMedialLocalThickness::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialLocalThickness::RequestInformation(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  const int done = this->RequestImageInformation(inputVector, outputVector, 0);
  vtkDataObject::SetActiveAttributeInfo(outputVector->GetInformationObject(0),
    vtkDataObject::FIELD_ASSOCIATION_POINTS, vtkDataSetAttributes::SCALARS, ArrayName, VTK_FLOAT, 1,
    -1);
  return done;
}

//------------------------------------------------------------------------------
int vtkMedialLocalThickness::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkImageData* output = vtkImageData::GetData(outInfo);
  const bool done = this->Internals->Try(
    [&]
    {
      vtkInternals::Begin(outputVector);
      vtkProgressBridge progress(this);
      medial::LocalThicknessOptions options;
      options.side = vtkMedialSides.ToLibrary(this->Side);
      options.bins = this->NumberOfBins;
      options.field = this->Internals->MakeOptions(progress);
      this->Internals->UpdateMesh(vtkPolyData::GetData(inputVector[0]), options.field.execution);
      const medial::Grid grid = vtkInternals::AnnouncedGrid(outInfo);
      float* const values = Allocate(output, grid);
      const medial::LocalThicknessStatistics statistics = medial::computeLocalThickness(
        this->Internals->Mesh, this->Internals->Connectivity, grid, values, options);
      this->Internals->Record(grid, statistics.field, output);
      Record(statistics.thickness, "Thickness", output);
      Record(statistics.separation, "Separation", output);
      // The balls at any point decide, so that a part takes the whole image.
      output->Crop(outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
      vtkWarnOnce(this, statistics.field.note);
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialLocalThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Side: " << this->GetSideAsString() << "\n";
  os << indent << "NumberOfBins: " << this->NumberOfBins << "\n";
}
