/**
 * @class   vtkMedialPolyDataAlgorithm
 * @brief   superclass of the filters that make vtkPolyData of vtkPolyData, without a distance field
 *
 * vtkMedialPolyDataAlgorithm executes vtkMedialThickness, vtkMedialReconstruction, vtkMedialCurves
 * and vtkMeshProximity: their errors, abort and parallel pipelines are the same.
 *
 * @par Errors:
 * A parameter outside its range and input that cannot be used are reported by one vtkErrorMacro
 * with the value and the allowed range; GetErrorCode() is then one of
 * vtkMeshFieldAlgorithm::ErrorCodes, the output is empty and the request ends as it does for
 * vtkMeshFieldAlgorithm. Observers of ErrorEvent are told even while
 * vtkObject::GlobalWarningDisplay is off. Parameters are checked when the filter executes; no value
 * is clamped.
 *
 * @par Abort:
 * SetAbortExecute(1) from a ProgressEvent observer stops the execution soon. The output is then
 * empty, GetErrorCode() is vtkMeshFieldAlgorithm::CancelledError without an ErrorEvent from the
 * filter, and the next Update() executes again.
 *
 * @par Time:
 * The outputs have the time steps of all inputs; each is asked for the time that is requested.
 *
 * @par Parallel pipelines:
 * No output is split: piece 0 is all of it, every other piece is empty. Whatever piece is
 * requested, the filter asks for the whole of its inputs.
 *
 * @sa
 * vtkMedialThickness vtkMedialReconstruction vtkMedialCurves vtkMeshProximity
 * vtkMeshFieldAlgorithm
 */

#ifndef vtkMedialPolyDataAlgorithm_h
#define vtkMedialPolyDataAlgorithm_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // For the data of all ports

class VTKMEDIALFILTERS_EXPORT vtkMedialPolyDataAlgorithm : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for obtaining type information, and printing.
   */
  vtkTypeMacro(vtkMedialPolyDataAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

protected:
  vtkMedialPolyDataAlgorithm();
  ~vtkMedialPolyDataAlgorithm() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /**
   * Fills the empty outputs, one for each output port, from the inputs, one for each input port.
   * What it throws becomes an error or, where it is medial::Error Cancelled, the end of an
   * execution that was aborted.
   */
  virtual void Execute(const std::vector<vtkPolyData*>& inputs,
    const std::vector<vtkPolyData*>& outputs) = 0;

private:
  vtkMedialPolyDataAlgorithm(const vtkMedialPolyDataAlgorithm&) = delete;
  void operator=(const vtkMedialPolyDataAlgorithm&) = delete;
};

#endif
