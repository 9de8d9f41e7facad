#pragma once

#include "medial/common/grid.h"

#include <vtkAlgorithm.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkMeshFieldAlgorithm.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

// What the tests of the filters have in common.
namespace medial::test
{

/// Records events of an algorithm and of its executive, and keeps their errors off the terminal.
class EventLog
{
public:
  explicit EventLog(vtkAlgorithm* algorithm);
  ~EventLog();
  EventLog(const EventLog&) = delete;
  EventLog& operator=(const EventLog&) = delete;

  int executions = 0;              ///< StartEvents
  std::vector<std::string> errors; ///< messages of the algorithm's own ErrorEvents
  int pipelineErrors = 0;          ///< ErrorEvents of its executive
  std::vector<double> progress;    ///< what GetProgress() was at each ProgressEvent
  std::vector<std::string> phases; ///< GetProgressText() at each ProgressEvent
  int abortAtProgress = -1;        ///< sets AbortExecute at the ProgressEvent of this index

private:
  void onAlgorithm(vtkObject* caller, unsigned long event, void* data);
  void onExecutive(vtkObject* caller, unsigned long event, void* data);

  vtkSmartPointer<vtkAlgorithm> algorithm_;
  std::vector<unsigned long> tags_;
  unsigned long executiveTag_ = 0;
};

/// Cube of the given half sides about the origin, as six quads with outward orientation.
vtkSmartPointer<vtkPolyData> boxPolyData(const Point3& halfSides);

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

/// True when an image has neither points nor arrays.
bool isEmpty(vtkImageData* image);

} // namespace medial::test
