// What the filters over a grid refuse, and how they say so.
#include "filter_contract.h"

#include <vtkNew.h>
#include <vtkPoints.h>

#include <cmath>
#include <limits>

namespace
{

using namespace medial::test;

TYPED_TEST_SUITE(FilterContract, GridFilters);

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
  this->expectError([](F f) { f->SetEngine(4); }, [](F f) { f->SetEngine(0); }, "Engine 4");
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
  this->expectError(spacing(0.1, 0.0, 0.1), repair, "spacing along y 0 is outside (0, infinity)");
  this->expectError(spacing(0.1, 0.1, -2.0), repair, "spacing along z -2 is outside (0, infinity)");
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
  this->expectError([](F f) { f->SetSignMethod(4); }, [](F f) { f->SetSignMethodToNone(); },
    "SignMethod 4 is not one of 0 (auto), 1 (none), 2 (pseudonormal), 3 (winding)");
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

TYPED_TEST(FilterContract, ObserversAreToldWhileWarningsAreOff)
{
  auto filter = this->make(boxPolyData());
  filter->SetResolution(1);
  EventLog log(filter);
  vtkObject::GlobalWarningDisplayOff();
  const bool done = update(filter);
  vtkObject::GlobalWarningDisplayOn();
  EXPECT_FALSE(done);
  ASSERT_EQ(log.errors.size(), 1u);
  EXPECT_NE(log.errors[0].find("): resolution 1 is outside [2, 8192]"), std::string::npos);
}

TYPED_TEST(FilterContract, MissingInputIsAnErrorOfThePipeline)
{
  vtkNew<TypeParam> filter;
  EventLog log(filter);
  EXPECT_FALSE(update(filter));
  EXPECT_EQ(log.executions, 0);
  EXPECT_GE(log.pipelineErrors, 1);
}

TYPED_TEST(FilterContract, DeviceThatIsNotThereIsRefused)
{
  auto filter = this->make(boxPolyData());
  filter->SetEngineToRasteriser();
  filter->SetDevice("Voodoo");
  EventLog log(filter);
  EXPECT_FALSE(update(filter));
  EXPECT_EQ(filter->GetErrorCode(), vtkMeshFieldAlgorithm::NoGpuError);
  filter->SetDevice("0");
  EXPECT_TRUE(update(filter));
}

TYPED_TEST(FilterContract, DeviceThatIsNotThereLeavesTheWorkToTheProcessorWithAWarning)
{
  auto filter = this->make(boxPolyData());
  const std::string device = std::string("Voodoo of ") + filter->GetClassName();
  filter->SetDevice(device.c_str());
  EventLog log(filter);
  EXPECT_TRUE(update(filter));
  EXPECT_EQ(textFigure(filter->GetOutput(), "Engine"), "Processor");
  const std::string note = textFigure(filter->GetOutput(), "EngineNote");
  EXPECT_EQ(note.rfind("the engine device failed (", 0), 0u) << note;
  ASSERT_EQ(log.warnings.size(), 1u);
  EXPECT_NE(log.warnings[0].find(note), std::string::npos) << log.warnings[0];
  EXPECT_NE(note.find(device), std::string::npos) << note;
  // Once a process and cause, whatever the numbers.
  filter->SetResolution(15);
  EXPECT_TRUE(update(filter));
  auto another = this->make(boxPolyData());
  another->SetDevice((device + "99").c_str());
  EventLog anotherLog(another);
  EXPECT_TRUE(update(another));
  EXPECT_EQ(log.warnings.size() + anotherLog.warnings.size(), 1u);
  another->SetDevice("");
  EXPECT_TRUE(update(another));
  EXPECT_EQ(textFigure(another->GetOutput(), "EngineNote"), "");
}

TYPED_TEST(FilterContract, RequireHardwareRefusesASoftwareRenderer)
{
  auto filter = this->make(boxPolyData());
  filter->SetEngineToRasteriser();
  filter->Update();
  const bool software = figure(filter->GetOutput(), "SoftwareRenderer") != 0.0;
  EventLog log(filter);
  filter->SetEngineToProcessor();
  filter->RequireHardwareOn();
  EXPECT_EQ(update(filter), !software);
  EXPECT_EQ(log.errors.empty(), !software);
  EXPECT_EQ(filter->GetErrorCode() == vtkMeshFieldAlgorithm::NoGpuError, software);
}

} // namespace
