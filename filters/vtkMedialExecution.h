/**
 * How all filters run the library: progress, abort, errors and threads in VTK's terms. Private to
 * the module.
 */

#ifndef vtkMedialExecution_h
#define vtkMedialExecution_h

#include "medial/execution.h"
#include "medial/side.h"
#include "medial/sign_method.h"

#include <functional>
#include <string>

class vtkAlgorithm;
class vtkInformation;
class vtkInformationVector;

/**
 * Runs work and turns what it throws into VTK's error reporting: errorCode, the algorithm's own,
 * becomes one of vtkMeshFieldAlgorithm::ErrorCodes, with an ErrorEvent unless an observer stopped
 * the work. Observers get it even while GlobalWarningDisplay is off. Returns whether all went well.
 */
bool vtkRunGuarded(vtkAlgorithm* algorithm, unsigned long& errorCode,
  const std::function<void()>& work);

/**
 * Warns of what a run says, once a process for each cause (numbers in it do not count). Nothing for
 * an empty note, and while GlobalWarningDisplay is off.
 */
void vtkWarnOnce(vtkAlgorithm* algorithm, const std::string& note);

/**
 * Ends an execution that failed or was stopped: the outputs are empty, and made again on the next
 * update. Returns what RequestData() is to return.
 */
int vtkEndWithoutOutput(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);

/**
 * Throws a medial::Error which says that the value of a parameter is not in range.
 */
[[noreturn]] void vtkThrowBadParameter(const char* name, int value, const char* range);

/**
 * The parameter NumberOfThreads and the receiver of progress as the library takes them. Throws if
 * the number is negative.
 */
medial::Execution vtkToExecution(int numberOfThreads, medial::Progress& progress);

///@{
/**
 * Conversions of the parameter Side: to the library's side (throws if the value is none of Sides),
 * to a word, and back from the library's side.
 */
medial::Side vtkToSide(int side);
const char* vtkSideAsString(int side);
int vtkFromSide(medial::Side side);
///@}

///@{
/**
 * The same for the parameter SignMethod, one of SignMethods.
 */
medial::SignMethod vtkToSignMethod(int method);
const char* vtkSignMethodAsString(int method);
int vtkFromSignMethod(medial::SignMethod method);
///@}

/**
 * Lets an input port take vtkPolyData and, where it may be in pieces, all that these come as. The
 * pipeline goes through the blocks of composite input that is not asked for.
 */
void vtkAcceptSurface(vtkInformation* port, bool inPieces);

///@{
/**
 * Asks for the whole input, or for one of several pieces without ghosts, whatever is asked of the
 * filter.
 */
void vtkRequestWhole(vtkInformation* request);
void vtkRequestPiece(vtkInformation* request, int piece, int pieces);
///@}

/**
 * Brings the first input up to date, as that. Returns whether its producer could.
 */
bool vtkUpdateInput(vtkAlgorithm* algorithm, int piece, int pieces);

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
