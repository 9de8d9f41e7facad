/**
 * How all filters run the library: abort, errors and threads in VTK's terms. Private to the module.
 */

#ifndef vtkMedialExecution_h
#define vtkMedialExecution_h

#include "vtkVersionMacros.h"

#include "medial/execution.h"

#include <functional>
#include <string>

// From this version on executives keep filters downstream from using the output of an aborted
// filter, without an error message of their own, and leave it to filters to reset AbortExecute.
#define MEDIAL_VTK_ABORTS_OUTPUTS (VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20221101))

class vtkAlgorithm;
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
[[noreturn]] void vtkThrowBadParameter(const char* name, int value, const std::string& range);

/**
 * The parameter NumberOfThreads and the receiver of progress as the library takes them. Throws if
 * the number is negative.
 */
medial::Execution vtkToExecution(int numberOfThreads, medial::Progress& progress);

#endif
