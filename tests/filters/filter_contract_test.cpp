// What a VTK pipeline may expect of both filters: updates, abort, progress.
#include "filter_contract.h"

#include "medial/compute_medial_axis.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSphereSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>

#include <type_traits>

namespace
{

using namespace medial::test;

/// A box whose half side is the time that is asked for, in [0, 2].
class GrowingBox : public vtkPolyDataAlgorithm
{
public:
  static GrowingBox* New();
  vtkTypeMacro(GrowingBox, vtkPolyDataAlgorithm);

protected:
  GrowingBox() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**,
    vtkInformationVector* outputVector) override
  {
    const double range[2] = { 0.0, 2.0 };
    outputVector->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(),
      range, 2);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**,
    vtkInformationVector* outputVector) override
  {
    vtkInformation* info = outputVector->GetInformationObject(0);
    const double time = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP());
    vtkPolyData* output = vtkPolyData::GetData(info);
    output->ShallowCopy(boxPolyData({ time, time, time }));
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    return 1;
  }
};

vtkStandardNewMacro(GrowingBox);

TYPED_TEST_SUITE(FilterContract, GridFilters);

TYPED_TEST(FilterContract, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<TypeParam> filter;
  EXPECT_EQ(filter->GetGridMode(), vtkMeshFieldAlgorithm::RESOLUTION);
  EXPECT_EQ(filter->GetResolution(), medial::kDefaultResolution);
  EXPECT_EQ(filter->GetPadding(), medial::kDefaultPadding);
  EXPECT_EQ(filter->GetSignMethod(), vtkMeshFieldAlgorithm::SIGN_AUTO);
  const medial::DistanceFieldOptions options;
  EXPECT_EQ(options.sign, medial::SignMethod::Auto);
  EXPECT_EQ(filter->GetEngine(), vtkMeshFieldAlgorithm::ENGINE_AUTO);
  EXPECT_EQ(options.engine, medial::Engine::Auto);
  EXPECT_EQ(filter->GetNumberOfThreads(), options.execution.threads);
  EXPECT_EQ(static_cast<std::size_t>(filter->GetMemoryLimit()), options.memoryMiB);
  EXPECT_EQ(filter->GetDevice(), options.device);
  EXPECT_EQ(filter->GetRequireHardware() != 0, options.requireHardware);
}

TYPED_TEST(FilterContract, SecondUpdateDoesNothing)
{
  auto filter = this->make(boxPolyData());
  EventLog log(filter);
  filter->Update();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
}

TYPED_TEST(FilterContract, ExecutionDoesNotModifyTheFilter)
{
  auto filter = this->make(boxPolyData());
  const vtkMTimeType time = filter->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetMTime(), time);
}

TYPED_TEST(FilterContract, TheSameDeviceDoesNotModifyTheFilter)
{
  auto filter = this->make(boxPolyData());
  const vtkMTimeType time = filter->GetMTime();
  filter->SetDevice("");
  filter->SetDevice(nullptr);
  EXPECT_EQ(filter->GetMTime(), time);
  filter->SetDevice("0");
  const vtkMTimeType changed = filter->GetMTime();
  EXPECT_GT(changed, time);
  filter->SetDevice("0");
  EXPECT_EQ(filter->GetMTime(), changed);
  filter->SetDevice(nullptr);
  EXPECT_STREQ(filter->GetDevice(), "");
}

TYPED_TEST(FilterContract, ExecutesAgainAfterAParameterChange)
{
  auto filter = this->make(boxPolyData());
  EventLog log(filter);
  filter->Update();
  const vtkIdType small = pointCount(filter);
  filter->SetResolution(22);
  filter->Update();
  const vtkIdType large = pointCount(filter);
  EXPECT_GT(large, small);
  filter->SetResolution(14); // fewer points than the last update extent
  filter->Update();
  EXPECT_EQ(pointCount(filter), small);
  filter->SetResolution(14);
  filter->Update();
  EXPECT_EQ(log.executions, 3);
  EXPECT_EQ(log.pipelineErrors, 0);
}

TYPED_TEST(FilterContract, ExecutesAgainAfterAnInputChange)
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<TypeParam> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetResolution(12);
  filter->Update();
  EXPECT_NEAR(filter->GetOutput()->GetLength(), 1.9, 1.9);
  const std::vector<double> before = figures(filter->GetOutput(), "GridSpacing");
  ASSERT_EQ(before.size(), 3u);
  sphere->SetRadius(50.0);
  filter->Update();
  const std::vector<double> after = figures(filter->GetOutput(), "GridSpacing");
  ASSERT_EQ(after.size(), 3u);
  EXPECT_NEAR(after[0], 100.0 * before[0], 1e-4 * after[0]);
}

TYPED_TEST(FilterContract, ExecutesAgainWhenPointsMoveInPlace)
{
  auto box = boxPolyData();
  auto filter = this->make(box);
  filter->Update();
  const std::vector<double> before = figures(filter->GetOutput(), "GridOrigin");
  ASSERT_EQ(before.size(), 3u);
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    const medial::Point3 x = pointOf(box, i);
    box->GetPoints()->SetPoint(i, x[0] + 10.0, x[1], x[2]);
  }
  box->GetPoints()->Modified();
  filter->Update();
  const std::vector<double> after = figures(filter->GetOutput(), "GridOrigin");
  ASSERT_EQ(after.size(), 3u);
  EXPECT_NEAR(after[0], before[0] + 10.0, 1e-9);
}

TYPED_TEST(FilterContract, ForgetsAMeshThatIsReplaced)
{
  auto filter = this->make(boxPolyData());
  filter->Update();
  for (int i = 1; i < 6; ++i)
  {
    // The old mesh dies; the new one may well live at its address.
    filter->SetInputData(boxPolyData({ 1.0 + i, 0.8, 0.6 }));
    filter->Update();
    const std::vector<double> origin = figures(filter->GetOutput(), "GridOrigin");
    ASSERT_EQ(origin.size(), 3u);
    EXPECT_LT(origin[0], -1.0 - i);
  }
}

// Two meshes with the same points have the time of the points when these were modified last.
TYPED_TEST(FilterContract, TellsMeshesWithCommonPointsApart)
{
  auto closed = boxPolyData();
  vtkNew<vtkCellArray> side;
  side->InsertNextCell({ 0, 4, 6, 2 });
  vtkNew<vtkPolyData> open;
  open->SetPoints(closed->GetPoints());
  open->SetPolys(side);
  auto filter = this->make(closed);
  closed->GetPoints()->Modified();
  ASSERT_EQ(open->GetMTime(), closed->GetMTime());
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "Closed"), 1.0);
  filter->SetInputData(open);
  filter->Update();
  EXPECT_EQ(figure(filter->GetOutput(), "Closed"), 0.0);
}

TYPED_TEST(FilterContract, FollowsInputThatChangesWithTime)
{
  vtkNew<GrowingBox> box;
  vtkNew<TypeParam> filter;
  filter->SetInputConnection(box->GetOutputPort());
  filter->SetGridModeToExplicit();
  filter->SetOrigin(-2.01, -2.02, -2.03);
  filter->SetSpacing(0.2, 0.2, 0.2);
  filter->SetDimensions(21, 21, 21);
  for (const double time : { 1.0, 1.5, 1.0, 0.5 })
  {
    filter->UpdateTimeStep(time);
    // The box is as deep as its half side, near its centre.
    double range[2];
    filter->GetOutput()->GetPointData()->GetScalars()->GetRange(range);
    const bool isAxis = std::is_same_v<TypeParam, vtkMedialAxis>;
    EXPECT_NEAR(isAxis ? range[1] : -range[0], time, 0.2);
    EXPECT_NEAR(filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()), time,
      1e-12);
  }
}

TYPED_TEST(FilterContract, TrivialProducerIsASourceLikeAnyOther)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(boxPolyData());
  vtkNew<TypeParam> filter;
  filter->SetInputConnection(producer->GetOutputPort());
  filter->SetResolution(14);
  filter->Update();
  auto direct = this->make(boxPolyData());
  direct->Update();
  EXPECT_GT(pointCount(filter), 0);
  EXPECT_EQ(pointCount(filter), pointCount(direct));
}

TYPED_TEST(FilterContract, WorksWhereTheInputReleasesItsData)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->ReleaseDataFlagOn();
  vtkNew<TypeParam> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetResolution(12);
  filter->SetPadding(0.1);
  EXPECT_TRUE(update(filter));
  filter->SetPadding(0.2);
  EXPECT_TRUE(update(filter));
  EXPECT_EQ(figure(filter->GetOutput(), "Triangles"), 96.0);
}

TYPED_TEST(FilterContract, ReportsProgress)
{
  auto filter = this->make(lumpPolyData());
  EventLog log(filter);
  filter->Update();
  expectProgressToTheEnd(log);
  EXPECT_FALSE(log.phases[log.phases.size() / 2].empty());
}

TYPED_TEST(FilterContract, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  expectAbortLeavesNothing(this->make(lumpPolyData()), 1);
}

TYPED_TEST(FilterContract, AbortWorksAtEveryProgressEvent)
{
  // How many events there are depends on time. Those at 1 may come after all work is done.
  auto filter = this->make(lumpPolyData());
  std::size_t event = 0;
  for (double progress = 0.0; progress < 1.0; ++event)
  {
    filter->Modified();
    EventLog log(filter);
    log.abortAtProgress = static_cast<int>(event);
    filter->Update();
    progress = event < log.progress.size() ? log.progress[event] : 1.0;
    if (progress < 1.0)
    {
      EXPECT_EQ(pointCount(filter), 0) << "aborted at event " << event << ", progress " << progress;
    }
  }
  EXPECT_GT(event, 2U);
}

TYPED_TEST(FilterContract, LimitsDoNotChangeTheResult)
{
  auto filter = this->make(lumpPolyData());
  filter->Update();
  auto limited = this->make(lumpPolyData());
  limited->SetNumberOfThreads(1);
  limited->SetMemoryLimit(64);
  limited->Update();
  ASSERT_EQ(pointCount(limited), pointCount(filter));
  const char* array = std::is_same_v<TypeParam, vtkMedialAxis> ? "Radius" : "Distance";
  for (vtkIdType i = 0; i < pointCount(filter); ++i)
  {
    ASSERT_NEAR(valueOf(limited->GetOutput(), array, i), valueOf(filter->GetOutput(), array, i),
      1e-3);
  }
}

} // namespace
