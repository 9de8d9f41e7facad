// Surfaces of balls, cones and wedges whose volumes are known, and what a pipeline may expect.
#include "filter_support.h"

#include <gtest/gtest.h>

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkMassProperties.h>
#include <vtkMedialAxis.h>
#include <vtkMedialReconstruction.h>
#include <vtkMeshFieldAlgorithm.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangle.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace
{

using namespace medial::test;

const double kPi = std::acos(-1.0);

vtkSmartPointer<vtkPolyData> balls(const std::vector<medial::Point3>& centres,
  const std::vector<float>& radii)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> radius;
  radius->SetName("Radius");
  for (std::size_t i = 0; i < centres.size(); ++i)
  {
    points->InsertNextPoint(centres[i].data());
    radius->InsertNextValue(radii[i]);
  }
  auto axis = vtkSmartPointer<vtkPolyData>::New();
  axis->SetPoints(points);
  axis->GetPointData()->AddArray(radius);
  return axis;
}

vtkSmartPointer<vtkPolyData> line(float first, float second)
{
  auto axis = balls({ { 0, 0, -1 }, { 0, 0, 1 } }, { first, second });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  axis->SetLines(lines);
  return axis;
}

vtkSmartPointer<vtkPolyData> plate()
{
  auto axis =
    balls({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 } }, { 0.25F, 0.25F, 0.25F, 0.25F });
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  axis->SetPolys(quads);
  return axis;
}

constexpr double kBallPart = 4.0 / 3.0; // of pi r^3

double plateVolume()
{
  return 8.0 * 0.25 + 8.0 * 0.5 * kPi * 0.0625 + kBallPart * kPi * 0.015625;
}

// Hull of balls of radii 1 and 0.5 at a distance of 2: two caps and the frustum between them.
double coneVolume()
{
  const double slope = 0.25;
  const double shrink = std::sqrt(1.0 - slope * slope);
  const auto cap = [&](double r, double height)
  { return kPi * height * height * (3.0 * r - height) / 3.0; };
  const double wide = shrink;
  const double narrow = 0.5 * shrink;
  const double length = 2.0 - slope + 0.5 * slope;
  return cap(1.0, 1.0 + slope) + cap(0.5, 0.5 * (1.0 - slope)) +
    kPi * length * (wide * wide + wide * narrow + narrow * narrow) / 3.0;
}

vtkSmartPointer<vtkMedialReconstruction> make(vtkPolyData* axis, int resolution = 48)
{
  auto filter = vtkSmartPointer<vtkMedialReconstruction>::New();
  filter->SetInputData(axis);
  filter->SetResolution(resolution);
  return filter;
}

double volumeOf(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> properties;
  properties->SetInputData(surface);
  return properties->GetVolume();
}

double volume(vtkPolyData* axis, int resolution)
{
  auto filter = make(axis, resolution);
  filter->Update();
  return volumeOf(filter->GetOutput());
}

// The volume's error is small, and falls with the square of the spacing.
void expectVolume(vtkPolyData* axis, double exact)
{
  const double coarse = std::abs(volume(axis, 24) - exact) / exact;
  const double middle = std::abs(volume(axis, 48) - exact) / exact;
  const double fine = std::abs(volume(axis, 96) - exact) / exact;
  EXPECT_LT(coarse, 0.05);
  EXPECT_LT(middle, 0.4 * coarse);
  EXPECT_LT(fine, 0.4 * middle);
}

void expectError(const std::function<void(vtkMedialReconstruction*)>& spoil,
  const std::string& words)
{
  auto filter = make(line(0.5F, 0.5F));
  const auto repair = [&]
  {
    filter->SetInputData(line(0.5F, 0.5F));
    filter->SetResolution(20);
  };
  expectErrorAndRecovery(
    filter, [&] { spoil(filter); }, repair, words);
}

TEST(MedialReconstruction, Ball)
{
  expectVolume(balls({ { 0.3, -0.2, 0.1 } }, { 0.7F }), kBallPart * kPi * 0.343);
}

TEST(MedialReconstruction, Capsule)
{
  expectVolume(line(0.5F, 0.5F), kPi * 0.25 * 2.0 + kBallPart * kPi * 0.125);
}

TEST(MedialReconstruction, Cone)
{
  expectVolume(line(1.0F, 0.5F), coneVolume());
}

TEST(MedialReconstruction, Plate)
{
  expectVolume(plate(), plateVolume());
}

TEST(MedialReconstruction, BallsAloneWithoutInterpolation)
{
  auto filter = make(line(0.5F, 0.75F), 96);
  filter->InterpolateOff();
  filter->Update();
  EXPECT_NEAR(volumeOf(filter->GetOutput()), kBallPart * kPi * (0.125 + 0.421875), 0.01);
  filter->InterpolateOn();
  filter->Update();
  EXPECT_GT(volumeOf(filter->GetOutput()), 3.0);
}

TEST(MedialReconstruction, PointsAreOnTheSurfaceAndNormalsPointOutwards)
{
  auto filter = make(line(0.5F, 0.5F), 64);
  filter->Update();
  vtkPolyData* surface = filter->GetOutput();
  ASSERT_GT(surface->GetNumberOfPoints(), 1000);
  const double voxel = 3.0 * 1.1 / 63;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const medial::Point3 x = pointOf(surface, i);
    const double z = std::max(-1.0, std::min(1.0, x[2]));
    const medial::Point3 centre{ 0.0, 0.0, z };
    ASSERT_NEAR(distanceBetween(x, centre), 0.5, 0.2 * voxel);
    const medial::Point3 normal = vectorOf(surface, "Normals", i);
    const double along = normal[0] * x[0] + normal[1] * x[1] + normal[2] * (x[2] - z);
    ASSERT_GT(along, 0.49);
  }
  // Triangles face the same way.
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkCell* triangle = surface->GetCell(cell);
    ASSERT_EQ(triangle->GetNumberOfPoints(), 3);
    double corners[3][3];
    double normal[3];
    for (int i = 0; i < 3; ++i)
    {
      surface->GetPoint(triangle->GetPointId(i), corners[i]);
    }
    vtkTriangle::ComputeNormalDirection(corners[0], corners[1], corners[2], normal);
    const medial::Point3 expected = vectorOf(surface, "Normals", triangle->GetPointId(0));
    ASSERT_GE(normal[0] * expected[0] + normal[1] * expected[1] + normal[2] * expected[2], 0.0);
  }
}

TEST(MedialReconstruction, FarFromTheOriginItIsTheSame)
{
  auto near = make(plate(), 40);
  near->Update();
  auto axis = plate();
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    const medial::Point3 x = pointOf(axis, i);
    axis->GetPoints()->SetPoint(i, x[0] + 1e6, x[1] - 2e6, x[2]);
  }
  auto far = make(axis, 40);
  far->Update();
  vtkPolyData* surface = far->GetOutput();
  ASSERT_GT(surface->GetNumberOfPoints(), 1000);
  double bounds[6];
  double expected[6];
  surface->GetBounds(bounds);
  near->GetOutput()->GetBounds(expected);
  EXPECT_NEAR(bounds[0], expected[0] + 1e6, 1e-5);
  EXPECT_NEAR(bounds[3], expected[3] - 2e6, 1e-5);
}

TEST(MedialReconstruction, SurfaceIsClosed)
{
  auto filter = make(plate(), 40);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputConnection(filter->GetOutputPort());
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfCells(), 1000);
}

TEST(MedialReconstruction, BoxComesBackFromItsAxis)
{
  vtkNew<vtkMedialAxis> axis;
  axis->SetInputData(boxPolyData());
  axis->SetResolution(48);
  axis->SetAngle(30.0);
  vtkNew<vtkMedialReconstruction> filter;
  filter->SetInputConnection(axis->GetOutputPort());
  filter->SetResolution(64);
  filter->Update();
  EXPECT_NEAR(volumeOf(filter->GetOutput()), 8.0 * 0.48, 0.1);
}

TEST(MedialReconstruction, SecondUpdateDoesNothingAndParametersExecuteAgain)
{
  auto filter = make(plate());
  EventLog log(filter);
  const vtkMTimeType time = filter->GetMTime();
  filter->Update();
  filter->Update();
  EXPECT_EQ(log.executions, 1);
  EXPECT_EQ(filter->GetMTime(), time);
  filter->InterpolateOff();
  filter->Update();
  filter->SetResolution(20);
  filter->Update();
  EXPECT_EQ(log.executions, 3);
  EXPECT_TRUE(log.errors.empty());
}

TEST(MedialReconstruction, PieceZeroIsAllOfIt)
{
  auto filter = make(plate());
  filter->UpdatePiece(1, 2, 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  filter->UpdatePiece(0, 2, 0);
  EXPECT_GT(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(MedialReconstruction, ReportsProgress)
{
  auto filter = make(plate());
  EventLog log(filter);
  filter->Update();
  expectProgressToTheEnd(log);
}

TEST(MedialReconstruction, AbortLeavesNothingAndTheNextUpdateExecutesAgain)
{
  std::size_t events = 0;
  {
    auto filter = make(plate());
    EventLog log(filter);
    filter->Update();
    events = log.progress.size();
  }
  for (std::size_t i = 0; i + 1 < events; ++i)
  {
    expectAbortLeavesNothing(make(plate()), i);
  }
}

TEST(MedialReconstruction, RefusesWhatIsNoAxis)
{
  using F = vtkMedialReconstruction*;
  expectError([](F f) { f->SetInputData(boxPolyData({ 1, 1, 1 })); }, "no point data array Radius");
  expectError(
    [](F f)
    {
      auto axis = line(1.0F, 1.0F);
      axis->GetPointData()->GetArray("Radius")->SetNumberOfComponents(2);
      f->SetInputData(axis);
    },
    "Radius has 2 components");
  expectError([](F f) { f->SetInputData(line(1.0F, -0.5F)); }, "point 1: radius -0.5 is outside");
  expectError([](F f) { f->SetInputData(line(1.0F, std::numeric_limits<float>::quiet_NaN())); },
    "point 1: radius nan is outside");
  expectError([](F f) { f->SetInputData(balls({}, {})); }, "0 points");
  expectError([](F f) { f->SetResolution(1); }, "resolution 1 is outside [2, 8192]");
  expectError([](F f) { f->SetResolution(9000); }, "9000");
}

TEST(MedialReconstruction, RefusesAGridLargerThanMemory)
{
  auto filter = make(balls({ { 0, 0, 0 } }, { 1.0F }));
  filter->SetResolution(8192);
  EventLog log(filter);
  EXPECT_FALSE(update(filter));
  ASSERT_EQ(log.errors.size(), 1u);
  EXPECT_NE(log.errors[0].find(" MiB are available"), std::string::npos) << log.errors[0];
  EXPECT_EQ(filter->GetErrorCode(),
    static_cast<unsigned long>(vtkMeshFieldAlgorithm::OutOfMemoryError));
}

TEST(MedialReconstruction, BallsWithoutRadiusLeaveNothing)
{
  auto filter = make(balls({ { 0, 0, 0 }, { 1, 0, 0 } }, { 0.0F, 0.0F }));
  EXPECT_TRUE(update(filter));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), 0);
}

} // namespace
