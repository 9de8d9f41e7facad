#include "filter_support.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkDataObject.h>
#include <vtkElevationFilter.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace medial::test
{

EventLog::EventLog(vtkAlgorithm* algorithm)
  : algorithm_(algorithm)
{
  for (const unsigned long event : { vtkCommand::StartEvent, vtkCommand::ErrorEvent,
         vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
  {
    tags_.push_back(algorithm->AddObserver(event, this, &EventLog::onAlgorithm));
  }
  executiveTag_ =
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this, &EventLog::onExecutive);
}

EventLog::~EventLog()
{
  for (const unsigned long tag : tags_)
  {
    algorithm_->RemoveObserver(tag);
  }
  algorithm_->GetExecutive()->RemoveObserver(executiveTag_);
}

void EventLog::onAlgorithm(vtkObject*, unsigned long event, void* data)
{
  if (event == vtkCommand::StartEvent)
  {
    ++executions;
  }
  else if (event == vtkCommand::ErrorEvent)
  {
    errors.emplace_back(static_cast<const char*>(data));
  }
  else if (event == vtkCommand::WarningEvent)
  {
    warnings.emplace_back(static_cast<const char*>(data));
  }
  else
  {
    if (static_cast<int>(progress.size()) == abortAtProgress)
    {
      algorithm_->SetAbortExecute(1);
    }
    progress.push_back(algorithm_->GetProgress());
    const char* text = algorithm_->GetProgressText();
    phases.emplace_back(text ? text : "");
  }
}

void EventLog::onExecutive(vtkObject*, unsigned long, void*)
{
  ++pipelineErrors;
}

bool update(vtkAlgorithm* filter)
{
  return filter->GetExecutive()->Update() != 0;
}

vtkIdType pointCount(vtkAlgorithm* filter)
{
  return filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT);
}

void expectInvalidInput(vtkAlgorithm* filter, const std::string& words)
{
  EventLog log(filter);
  EXPECT_FALSE(update(filter)) << words;
  ASSERT_EQ(log.errors.size(), 1u) << words;
  EXPECT_NE(log.errors[0].find(words), std::string::npos) << log.errors[0];
  EXPECT_EQ(filter->GetErrorCode(),
    static_cast<unsigned long>(vtkMeshFieldAlgorithm::InvalidInputError));
  EXPECT_EQ(pointCount(filter), 0) << words;
  EXPECT_EQ(filter->GetOutputDataObject(0)->GetFieldData()->GetNumberOfArrays(), 0) << words;
}

void expectErrorAndRecovery(vtkAlgorithm* filter, const std::function<void()>& spoil,
  const std::function<void()>& repair, const std::string& words)
{
  ASSERT_TRUE(update(filter)) << words;
  spoil();
  expectInvalidInput(filter, words);
  EventLog log(filter);
  repair();
  EXPECT_TRUE(update(filter)) << words;
  EXPECT_EQ(filter->GetErrorCode(), 0u) << words;
  EXPECT_GT(pointCount(filter), 0) << words;
  EXPECT_TRUE(log.errors.empty()) << words;
}

void expectProgressToTheEnd(const EventLog& log)
{
  ASSERT_GE(log.progress.size(), 3u);
  EXPECT_TRUE(std::is_sorted(log.progress.begin(), log.progress.end()));
  EXPECT_EQ(log.progress.front(), 0.0);
  EXPECT_EQ(log.progress.back(), 1.0);
}

void expectAbortLeavesNothing(vtkAlgorithm* filter, std::size_t event)
{
  vtkNew<vtkElevationFilter> downstream;
  downstream->SetInputConnection(filter->GetOutputPort());
  EventLog after(downstream);
  {
    EventLog log(filter);
    log.abortAtProgress = static_cast<int>(event);
    downstream->Update();
    EXPECT_EQ(log.executions, 1) << "at event " << event;
    EXPECT_TRUE(log.errors.empty()) << "at event " << event;
    EXPECT_EQ(after.executions, 0) << "at event " << event;
    EXPECT_EQ(pointCount(filter), 0) << "at event " << event;
    vtkDataObject* output = filter->GetOutputDataObject(0);
    EXPECT_EQ(output->GetAttributes(vtkDataObject::POINT)->GetNumberOfArrays(), 0);
    EXPECT_EQ(filter->GetErrorCode(),
      static_cast<unsigned long>(vtkMeshFieldAlgorithm::CancelledError));
  }
  downstream->Update();
  EXPECT_EQ(after.executions, 1);
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_GT(pointCount(filter), 0);
}

vtkSmartPointer<vtkPolyData> boxPolyData(const Point3& halfSides)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int corner = 0; corner < 8; ++corner)
  {
    points->InsertNextPoint((corner & 1) ? halfSides[0] : -halfSides[0],
      (corner & 2) ? halfSides[1] : -halfSides[1], (corner & 4) ? halfSides[2] : -halfSides[2]);
  }
  constexpr vtkIdType kQuads[6][4] = { { 0, 4, 6, 2 }, { 1, 3, 7, 5 }, { 0, 1, 5, 4 },
    { 2, 6, 7, 3 }, { 0, 2, 3, 1 }, { 4, 5, 7, 6 } };
  vtkNew<vtkCellArray> polys;
  for (const auto& quad : kQuads)
  {
    polys->InsertNextCell(4, quad);
  }
  auto box = vtkSmartPointer<vtkPolyData>::New();
  box->SetPoints(points);
  box->SetPolys(polys);
  return box;
}

vtkSmartPointer<vtkPolyData> spoiledBox(const std::function<void(vtkPolyData*)>& spoil)
{
  auto box = boxPolyData();
  spoil(box);
  return box;
}

double boxDistance(const Point3& halfSides, const Point3& x)
{
  double outside = 0.0;
  double inside = -HUGE_VAL;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double excess = std::abs(x[axis]) - halfSides[axis];
    inside = std::max(inside, excess);
    outside += std::pow(std::max(excess, 0.0), 2);
  }
  return inside > 0.0 ? std::sqrt(outside) : inside;
}

vtkSmartPointer<vtkPolyData> lumpPolyData()
{
  constexpr int kAround = 11;
  constexpr int kRings = 6;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.1, -1.1);
  for (int ring = 1; ring <= kRings; ++ring)
  {
    for (int i = 0; i < kAround; ++i)
    {
      const double theta = M_PI * ring / (kRings + 1);
      const double phi = 2.0 * M_PI * i / kAround;
      const double radius = 0.8 + 0.25 * std::sin(3.0 * phi + ring) + 0.05 * ((7 * i + ring) % 3);
      points->InsertNextPoint(radius * std::sin(theta) * std::cos(phi),
        radius * std::sin(theta) * std::sin(phi), -radius * std::cos(theta));
    }
  }
  const vtkIdType top = points->InsertNextPoint(0.1, 0.0, 0.9);
  vtkNew<vtkCellArray> polys;
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    polys->InsertNextCell({ a, b, c });
  };
  const auto at = [](int ring, int i) -> vtkIdType { return 1 + kAround * ring + i % kAround; };
  for (int i = 0; i < kAround; ++i)
  {
    add(0, at(0, i + 1), at(0, i));
    add(top, at(kRings - 1, i), at(kRings - 1, i + 1));
    for (int ring = 0; ring + 1 < kRings; ++ring)
    {
      add(at(ring, i), at(ring, i + 1), at(ring + 1, i));
      add(at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i));
    }
  }
  auto lump = vtkSmartPointer<vtkPolyData>::New();
  lump->SetPoints(points);
  lump->SetPolys(polys);
  return lump;
}

vtkSmartPointer<vtkPolyData> mixedPolyData()
{
  vtkNew<vtkPoints> points;
  constexpr float kPoints[][3] = { { 2, 2, 2 }, { -2, 1, 1 }, { -1, 2, 1 }, { -1, 2, 2 },
    { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, -2, 1 }, { 1, -2, 1 },
    { 0.5f, -1, 1.5f }, { 1.5f, -1, 1 }, { 1, 0, 2 } };
  for (const auto& point : kPoints)
  {
    points->InsertNextPoint(point);
  }
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 1, 2, 3 });
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 4, 5, 6, 7 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 8, 9, 10, 11, 12 });
  auto mixed = vtkSmartPointer<vtkPolyData>::New();
  mixed->SetPoints(points);
  mixed->SetVerts(verts);
  mixed->SetLines(lines);
  mixed->SetPolys(polys);
  mixed->SetStrips(strips);
  return mixed;
}

vtkSmartPointer<vtkPolyData> squarePolyData()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-1, -1, 0);
  points->InsertNextPoint(1, -1, 0);
  points->InsertNextPoint(1, 1, 0);
  points->InsertNextPoint(-1, 1, 0);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 2, 3 });
  auto square = vtkSmartPointer<vtkPolyData>::New();
  square->SetPoints(points);
  square->SetPolys(polys);
  return square;
}

double valueOf(vtkDataSet* data, const char* array, vtkIdType point)
{
  return data->GetPointData()->GetArray(array)->GetComponent(point, 0);
}

Point3 vectorOf(vtkDataSet* data, const char* array, vtkIdType point)
{
  Point3 result;
  data->GetPointData()->GetArray(array)->GetTuple(point, result.data());
  return result;
}

Point3 pointOf(vtkDataSet* data, vtkIdType point)
{
  Point3 result;
  data->GetPoint(point, result.data());
  return result;
}

double distanceBetween(const Point3& a, const Point3& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double distanceToCell(vtkPolyData* mesh, vtkIdType cell, const Point3& x)
{
  vtkCell* geometry = mesh->GetCell(cell);
  std::vector<double> weights(static_cast<std::size_t>(geometry->GetNumberOfPoints()));
  double closest[3];
  double pcoords[3];
  int subId = 0;
  double distance2 = 0.0;
  geometry->EvaluatePosition(x.data(), closest, subId, pcoords, distance2, weights.data());
  return std::sqrt(distance2);
}

std::vector<double> figures(vtkDataObject* data, const char* array)
{
  vtkDataArray* values = data->GetFieldData()->GetArray(array);
  std::vector<double> result;
  for (int i = 0; values && i < values->GetNumberOfComponents(); ++i)
  {
    result.push_back(values->GetComponent(0, i));
  }
  return result;
}

double figure(vtkDataObject* data, const char* array)
{
  const std::vector<double> values = figures(data, array);
  return values.size() == 1 ? values[0] : std::numeric_limits<double>::quiet_NaN();
}

std::string textFigure(vtkDataObject* data, const char* array)
{
  auto* texts = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(array));
  return texts && texts->GetNumberOfValues() == 1 ? texts->GetValue(0) : std::string();
}

bool isEmpty(vtkImageData* image)
{
  return image->GetNumberOfPoints() == 0 && image->GetPointData()->GetNumberOfArrays() == 0;
}

} // namespace medial::test
