#pragma once

#include "medial/grid.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkMeshFieldAlgorithm.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>
#include <vector>

// What the tests of the filters have in common.
namespace medial::test
{

/// Records events of an algorithm and of its executive, and keeps their errors and warnings off the
/// terminal.
class EventLog
{
public:
  explicit EventLog(vtkAlgorithm* algorithm);
  ~EventLog();
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  int executions = 0;                ///< StartEvents
  std::vector<std::string> errors;   ///< messages of the algorithm's own ErrorEvents
  std::vector<std::string> warnings; ///< those of its WarningEvents
  int pipelineErrors = 0;            ///< ErrorEvents of its executive
  std::vector<double> progress;      ///< what GetProgress() was at each ProgressEvent
  std::vector<std::string> phases;   ///< GetProgressText() at each ProgressEvent
  int abortAtProgress = -1;          ///< sets AbortExecute at the ProgressEvent of this index

private:
  void onAlgorithm(vtkObject* caller, unsigned long event, void* data);
  void onExecutive(vtkObject* caller, unsigned long event, void* data);

  vtkSmartPointer<vtkAlgorithm> algorithm_;
  std::vector<unsigned long> tags_;
  unsigned long executiveTag_ = 0;
};

/// Whether the pipeline above the algorithm, and the algorithm, execute without error.
bool update(vtkAlgorithm* filter);

/// Points of output 0.
vtkIdType pointCount(vtkAlgorithm* filter);

/// Expects an update to fail with one InvalidInputError whose message contains `words`, and to
/// leave no output.
void expectInvalidInput(vtkAlgorithm* filter, const std::string& words);

/// The same after `spoil`, of a filter that can be updated before, and can be again after `repair`.
void expectErrorAndRecovery(vtkAlgorithm* filter, const std::function<void()>& spoil,
  const std::function<void()>& repair, const std::string& words);

/// Expects progress from 0 to 1, some of it in between, never backwards.
void expectProgressToTheEnd(const EventLog& log);

/// Aborts the filter at a progress event, and expects that it leaves nothing and what is downstream
/// does not execute; then that all is done by the next update.
void expectAbortLeavesNothing(vtkAlgorithm* filter, std::size_t event);

/// Cube of the given half sides about the origin, as six quads with outward orientation.
vtkSmartPointer<vtkPolyData> boxPolyData(const Point3& halfSides = { 1.0, 0.8, 0.6 });

/// That box after `spoil`.
vtkSmartPointer<vtkPolyData> spoiledBox(const std::function<void(vtkPolyData*)>& spoil);

/// Signed distance to that box, negative inside.
double boxDistance(const Point3& halfSides, const Point3& x);

/// Octahedron-like closed surface without symmetry: `subdivisions` halvings and uneven radii.
vtkSmartPointer<vtkPolyData> lumpPolyData();

/// One of each: a vertex, a polyline, a quad and a strip of five points, far apart, ids 0 to 3.
vtkSmartPointer<vtkPolyData> mixedPolyData();

/// The open square |x|, |y| <= 1 at z = 0.
vtkSmartPointer<vtkPolyData> squarePolyData();

/// Value of component 0 of a point data array.
double valueOf(vtkDataSet* data, const char* array, vtkIdType point);
Point3 vectorOf(vtkDataSet* data, const char* array, vtkIdType point);
Point3 pointOf(vtkDataSet* data, vtkIdType point);
double distanceBetween(const Point3& a, const Point3& b);

/// Distance from a point to one cell, by VTK.
double distanceToCell(vtkPolyData* mesh, vtkIdType cell, const Point3& x);

/// The values of a field data array, of its one tuple; nothing where there is no such array.
std::vector<double> figures(vtkDataObject* data, const char* array);
/// The only one of them; NaN where there is none.
double figure(vtkDataObject* data, const char* array);
/// The only text of a field data array; empty where there is no such array.
std::string textFigure(vtkDataObject* data, const char* array);

/// True when an image has neither points nor arrays.
bool isEmpty(vtkImageData* image);

} // namespace medial::test
