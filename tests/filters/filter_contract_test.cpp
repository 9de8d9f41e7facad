// What a VTK pipeline may expect of both filters: updates, errors, abort, progress.
#include "filter_support.h"

#include "medial/medial/medial_axis.h"

#include <gtest/gtest.h>

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkElevationFilter.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMedialAxis.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataAlgorithm.h>
#include <vtkSphereSource.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

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

template <typename Filter>
class FilterContract : public testing::Test
{
protected:
  vtkSmartPointer<Filter> make(vtkPolyData* mesh)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(mesh);
    filter->SetResolution(14);
    return filter;
  }

  /// Points of the output that the filter is about.
  static vtkIdType size(Filter* filter) { return filter->GetOutput()->GetNumberOfPoints(); }

  static bool update(Filter* filter) { return filter->GetExecutive()->Update() != 0; }

  /// Sets the parameter, updates, and expects an error that names it; then that all is well again
  /// after `repair`.
  void expectError(const std::function<void(Filter*)>& spoil,
    const std::function<void(Filter*)>& repair, const std::string& words)
  {
    auto filter = make(boxPolyData({ 1.0, 0.8, 0.6 }));
    ASSERT_TRUE(update(filter)) << words;
    EventLog log(filter);
    spoil(filter);
    EXPECT_FALSE(update(filter)) << words;
    ASSERT_EQ(log.errors.size(), 1u) << words;
    EXPECT_NE(log.errors[0].find(words), std::string::npos) << log.errors[0];
    EXPECT_EQ(filter->GetErrorCode(),
      static_cast<unsigned long>(vtkMeshFieldAlgorithm::InvalidInputError));
    EXPECT_EQ(size(filter), 0) << words;
    EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
    EXPECT_STREQ(filter->GetRenderer(), "") << words;
    repair(filter);
    EXPECT_TRUE(update(filter)) << words;
    EXPECT_EQ(filter->GetErrorCode(), 0u) << words;
    EXPECT_GT(size(filter), 0) << words;
    EXPECT_EQ(log.errors.size(), 1u) << words;
  }

  void expectBadMesh(const std::function<void(vtkPolyData*)>& spoil, const std::string& words)
  {
    auto box = boxPolyData({ 1.0, 0.8, 0.6 });
    expectError(
      [&](Filter* filter)
      {
        spoil(box);
        filter->SetInputData(box);
      },
      [](Filter* filter) {
        filter->SetInputData(boxPolyData({ 1.0, 1.0, 1.0 }));
      },
      words);
  }
};

using Filters = testing::Types<vtkMeshDistanceField, vtkMedialAxis>;
TYPED_TEST_SUITE(FilterContract, Filters);

TYPED_TEST(FilterContract, DefaultsAreThoseOfTheLibrary)
{
  vtkNew<TypeParam> filter;
  EXPECT_EQ(filter->GetGridMode(), vtkMeshFieldAlgorithm::RESOLUTION);
  EXPECT_EQ(filter->GetResolution(), medial::kDefaultResolution);
  EXPECT_EQ(filter->GetPadding(), medial::kDefaultPadding);
  EXPECT_EQ(filter->GetSignMethod(), vtkMeshFieldAlgorithm::SIGN_AUTO);
  const medial::DistanceFieldOptions options;
  EXPECT_EQ(options.sign, medial::SignMethod::Auto);
  EXPECT_EQ(filter->GetEvaluator(), vtkMeshFieldAlgorithm::EVALUATOR_AUTO);
  EXPECT_EQ(options.evaluator, medial::Evaluator::Auto);
  EXPECT_EQ(filter->GetNumberOfThreads(), options.threads);
  EXPECT_EQ(static_cast<std::size_t>(filter->GetMemoryLimit()), options.memoryMiB);
  EXPECT_EQ(filter->GetRequireHardware() != 0, options.requireHardware);
}

TYPED_TEST(FilterContract, SecondUpdateDoesNothing)
{
  auto filter = this->make(boxPolyData({ 1.0, 0.8, 0.6 }));
  EventLog log(filter);
  filter->Update();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
}

TYPED_TEST(FilterContract, ExecutionDoesNotModifyTheFilter)
{
  auto filter = this->make(boxPolyData({ 1.0, 0.8, 0.6 }));
  const vtkMTimeType time = filter->GetMTime();
  filter->Update();
  EXPECT_EQ(filter->GetMTime(), time);
}

TYPED_TEST(FilterContract, ExecutesAgainAfterAParameterChange)
{
  auto filter = this->make(boxPolyData({ 1.0, 0.8, 0.6 }));
  EventLog log(filter);
  filter->Update();
  const vtkIdType small = this->size(filter);
  filter->SetResolution(22);
  filter->Update();
  const vtkIdType large = this->size(filter);
  EXPECT_GT(large, small);
  filter->SetResolution(14); // fewer points than the last update extent
  filter->Update();
  EXPECT_EQ(this->size(filter), small);
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
  double before[3];
  filter->GetUsedSpacing(before);
  sphere->SetRadius(50.0);
  filter->Update();
  double after[3];
  filter->GetUsedSpacing(after);
  EXPECT_NEAR(after[0], 100.0 * before[0], 1e-4 * after[0]);
}

TYPED_TEST(FilterContract, ExecutesAgainWhenPointsMoveInPlace)
{
  auto box = boxPolyData({ 1.0, 0.8, 0.6 });
  auto filter = this->make(box);
  filter->Update();
  double before[3];
  filter->GetUsedOrigin(before);
  for (vtkIdType i = 0; i < box->GetNumberOfPoints(); ++i)
  {
    const medial::Point3 x = pointOf(box, i);
    box->GetPoints()->SetPoint(i, x[0] + 10.0, x[1], x[2]);
  }
  box->GetPoints()->Modified();
  filter->Update();
  double after[3];
  filter->GetUsedOrigin(after);
  EXPECT_NEAR(after[0], before[0] + 10.0, 1e-9);
}

TYPED_TEST(FilterContract, ForgetsAMeshThatIsReplaced)
{
  auto filter = this->make(boxPolyData({ 1.0, 0.8, 0.6 }));
  filter->Update();
  for (int i = 1; i < 6; ++i)
  {
    // The old mesh dies; the new one may well live at its address.
    filter->SetInputData(boxPolyData({ 1.0 + i, 0.8, 0.6 }));
    filter->Update();
    double origin[3];
    filter->GetUsedOrigin(origin);
    EXPECT_LT(origin[0], -1.0 - i);
  }
}

// Two meshes with the same points have the time of the points when these were modified last.
TYPED_TEST(FilterContract, TellsMeshesWithCommonPointsApart)
{
  auto closed = boxPolyData({ 1.0, 0.8, 0.6 });
  vtkNew<vtkCellArray> side;
  side->InsertNextCell({ 0, 4, 6, 2 });
  vtkNew<vtkPolyData> open;
  open->SetPoints(closed->GetPoints());
  open->SetPolys(side);
  auto filter = this->make(closed);
  closed->GetPoints()->Modified();
  ASSERT_EQ(open->GetMTime(), closed->GetMTime());
  filter->Update();
  EXPECT_TRUE(filter->GetClosed());
  filter->SetInputData(open);
  filter->Update();
  EXPECT_FALSE(filter->GetClosed());
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
  producer->SetOutput(boxPolyData({ 1.0, 0.8, 0.6 }));
  vtkNew<TypeParam> filter;
  filter->SetInputConnection(producer->GetOutputPort());
  filter->SetResolution(14);
  filter->Update();
  auto direct = this->make(boxPolyData({ 1.0, 0.8, 0.6 }));
  direct->Update();
  EXPECT_GT(this->size(filter), 0);
  EXPECT_EQ(this->size(filter), this->size(direct));
}

TYPED_TEST(FilterContract, WorksWhereTheInputReleasesItsData)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->ReleaseDataFlagOn();
  vtkNew<TypeParam> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetResolution(12);
  filter->SetPadding(0.1);
  EXPECT_TRUE(this->update(filter));
  filter->SetPadding(0.2);
  EXPECT_TRUE(this->update(filter));
  EXPECT_EQ(filter->GetNumberOfTriangles(), 96);
}

TYPED_TEST(FilterContract, ReportsProgress)
{
  auto filter = this->make(lumpPolyData());
  EventLog log(filter);
  filter->Update();
  ASSERT_GE(log.progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(log.progress.begin(), log.progress.end()));
  EXPECT_EQ(log.progress.front(), 0.0);
  EXPECT_EQ(log.progress.back(), 1.0);
  EXPECT_FALSE(log.phases[log.phases.size() / 2].empty());
}

TYPED_TEST(FilterContract, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  auto filter = this->make(lumpPolyData());
  vtkNew<vtkElevationFilter> downstream;
  downstream->SetInputConnection(filter->GetOutputPort());
  EventLog after(downstream);
  {
    EventLog log(filter);
    log.abortAtProgress = 1;
    downstream->Update();
    EXPECT_EQ(log.executions, 1);
    EXPECT_TRUE(log.errors.empty());
    EXPECT_EQ(after.executions, 0);
    EXPECT_EQ(this->size(filter), 0);
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
    EXPECT_EQ(filter->GetErrorCode(),
      static_cast<unsigned long>(vtkMeshFieldAlgorithm::CancelledError));
  }
  downstream->Update();
  EXPECT_EQ(after.executions, 1);
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_GT(this->size(filter), 0);
}

TYPED_TEST(FilterContract, AbortWorksAtEveryProgressEvent)
{
  auto filter = this->make(lumpPolyData());
  std::size_t events = 0;
  {
    EventLog log(filter);
    filter->Update();
    events = log.progress.size();
  }
  // The last event but one may come when all work is done; the last one always does.
  for (std::size_t i = 0; i + 2 < events; ++i)
  {
    filter->Modified();
    EventLog log(filter);
    log.abortAtProgress = static_cast<int>(i);
    filter->Update();
    EXPECT_EQ(this->size(filter), 0) << "aborted at event " << i << " of " << events;
  }
}

TYPED_TEST(FilterContract, RefusesParametersOutsideTheirRange)
{
  using F = TypeParam*;
  const auto nan = std::numeric_limits<double>::quiet_NaN();
  this->expectError([](F f) { f->SetResolution(1); }, [](F f) { f->SetResolution(14); },
    "resolution 1 is outside [2, 8192]");
  this->expectError([](F f) { f->SetResolution(9000); }, [](F f) { f->SetResolution(14); }, "9000");
  this->expectError([](F f) { f->SetPadding(-0.1); }, [](F f) { f->SetPadding(0.1); }, "padding");
  this->expectError([=](F f) { f->SetPadding(nan); }, [](F f) { f->SetPadding(0.1); }, "padding");
  this->expectError([](F f) { f->SetGridMode(3); }, [](F f) { f->SetGridMode(0); }, "GridMode 3");
  this->expectError([](F f) { f->SetSignMethod(-1); }, [](F f) { f->SetSignMethod(0); },
    "SignMethod -1");
  this->expectError([](F f) { f->SetEvaluator(3); }, [](F f) { f->SetEvaluator(0); },
    "Evaluator 3");
  this->expectError([](F f) { f->SetNumberOfThreads(-2); }, [](F f) { f->SetNumberOfThreads(1); },
    "NumberOfThreads -2");
  this->expectError([](F f) { f->SetMemoryLimit(63); }, [](F f) { f->SetMemoryLimit(64); },
    "MemoryLimit 63");
  this->expectError([](F f) { f->SetMemoryLimit(-1); }, [](F f) { f->SetMemoryLimit(0); },
    "MemoryLimit -1");
}

TYPED_TEST(FilterContract, RefusesBadGrids)
{
  using F = TypeParam*;
  const auto repair = [](F f) { f->SetGridModeToResolution(); };
  const auto spacing = [](double x, double y, double z)
  {
    return [=](F f)
    {
      f->SetGridModeToSpacing();
      f->SetSpacing(x, y, z);
    };
  };
  this->expectError(spacing(0.1, 0.0, 0.1), repair, "spacing 0");
  this->expectError(spacing(0.1, 0.1, -2.0), repair, "spacing -2");
  this->expectError(spacing(0.1, 1e-5, 0.1), repair, "8192");
  const auto explicitly = [](int nx, double ox)
  {
    return [=](F f)
    {
      f->SetGridModeToExplicit();
      f->SetSpacing(0.1, 0.1, 0.1);
      f->SetDimensions(nx, 10, 10);
      f->SetOrigin(ox, -0.5, -0.5);
    };
  };
  this->expectError(explicitly(0, 0.0), repair, "dimension along x 0 is outside [1, 8192]");
  this->expectError(explicitly(10, HUGE_VAL), repair, "origin inf");
}

TYPED_TEST(FilterContract, RefusesUnusableInput)
{
  this->expectBadMesh([](vtkPolyData* box) { box->Initialize(); }, "no cells");
  this->expectBadMesh([](vtkPolyData* box) { box->SetPolys(nullptr); }, "no cells");
  this->expectBadMesh([](vtkPolyData* box)
    { box->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0); },
    "point 3");
  this->expectBadMesh([](vtkPolyData* box) { box->GetPoints()->SetPoint(5, 0.0, HUGE_VAL, 0.0); },
    "point 5");
}

TYPED_TEST(FilterContract, RefusesSignsThatTheMeshCannotHave)
{
  using F = TypeParam*;
  this->expectError([](F f) { f->SetSignMethodToWinding(); }, [](F f) { f->SetSignMethodToNone(); },
    "winding");
  this->expectError(
    [](F f)
    {
      f->SetSignMethodToPseudonormal();
      f->SetInputData(squarePolyData());
    },
    [](F f) {
      f->SetInputData(boxPolyData({ 1.0, 1.0, 1.0 }));
    },
    "pseudonormal");
}

TYPED_TEST(FilterContract, MissingInputIsAnErrorOfThePipeline)
{
  vtkNew<TypeParam> filter;
  EventLog log(filter);
  EXPECT_FALSE(this->update(filter));
  EXPECT_EQ(log.executions, 0);
  EXPECT_GE(log.pipelineErrors, 1);
}

TYPED_TEST(FilterContract, RequireHardwareRefusesASoftwareRenderer)
{
  auto filter = this->make(boxPolyData({ 1.0, 0.8, 0.6 }));
  filter->Update();
  const bool software = filter->GetSoftwareRenderer();
  EventLog log(filter);
  filter->RequireHardwareOn();
  EXPECT_EQ(this->update(filter), !software);
  EXPECT_EQ(log.errors.empty(), !software);
  EXPECT_EQ(filter->GetErrorCode() == vtkMeshFieldAlgorithm::NoGpuError, software);
}

TYPED_TEST(FilterContract, LimitsDoNotChangeTheResult)
{
  auto filter = this->make(lumpPolyData());
  filter->Update();
  auto limited = this->make(lumpPolyData());
  limited->SetNumberOfThreads(1);
  limited->SetMemoryLimit(64);
  limited->Update();
  ASSERT_EQ(this->size(limited), this->size(filter));
  const char* array = std::is_same_v<TypeParam, vtkMedialAxis> ? "Radius" : "Distance";
  for (vtkIdType i = 0; i < this->size(filter); ++i)
  {
    ASSERT_NEAR(valueOf(limited->GetOutput(), array, i), valueOf(filter->GetOutput(), array, i),
      1e-3);
  }
}

} // namespace
