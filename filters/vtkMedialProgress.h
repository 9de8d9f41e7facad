/**
 * Progress of the library and the wish to stop, in VTK's terms. Private to the module.
 */

#ifndef vtkMedialProgress_h
#define vtkMedialProgress_h

#include "medial/execution.h"

class vtkAlgorithm;

/**
 * Passes the library's progress on to a VTK algorithm's observers, and their requests to stop back
 * to the library.
 */
class vtkProgressBridge : public medial::Progress
{
public:
  /**
   * Starts a new execution: a request to stop an earlier one is forgotten.
   */
  explicit vtkProgressBridge(vtkAlgorithm* algorithm);

  void report(double fraction, const char* phase) override;
  bool cancelled() override;

  /**
   * As report(), for work of the filter itself. Throws medial::Error Cancelled if an observer wants
   * to stop.
   */
  void ReportOrStop(double fraction, const char* phase);

private:
  vtkAlgorithm* Algorithm;
};

/**
 * Progress of the library as a part of the execution, from one share of the work to another.
 */
class vtkProgressPart : public medial::Progress
{
public:
  vtkProgressPart(vtkProgressBridge& bridge, double from, double to)
    : Bridge(bridge)
    , From(from)
    , To(to)
  {
  }

  void report(double fraction, const char* phase) override;
  bool cancelled() override { return this->Bridge.cancelled(); }

private:
  vtkProgressBridge& Bridge;
  double From;
  double To;
};

#endif
