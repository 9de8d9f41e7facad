/**
 * @class   vtkDistributedFieldAlgorithm
 * @brief   superclass of the filters that take a surface in pieces on several processes
 *
 * Unless DistributedInput is on, every process (rank) needs the whole surface and works for itself.
 * With DistributedInput the inputs of all ranks together are the surface, and no rank ever holds
 * it: each makes its part of the output that one process makes of the whole by ENGINE_PROCESSOR,
 * bit for bit. An input may then also be a vtkUnstructuredGrid of triangles and polygons, or blocks
 * of both kinds, as parallel readers and vtkRedistributeDataSetFilter deliver them; ghost cells are
 * left out, and pieces may be empty. Points whose coordinates have the same bits are one, and so
 * are triangles with the same corners. Global ids of cells and points number them in the whole,
 * where all pieces have some; otherwise cells are numbered one piece after the other.
 *
 * The surface must consist of triangles and polygons, and Engine be ENGINE_AUTO or
 * ENGINE_PROCESSOR. The field data have no arrays of the mesh, but OwnTriangles, HeldTriangles and
 * BytesSent (vtkIdType): the triangles of the surface over the number of ranks, about; those that a
 * rank had to hold for its part; what it sent.
 *
 * All ranks must update the filter together, with the same parameters. What fails on one rank fails
 * on all, with a message that names the rank; so do parameters that differ. A pipeline in which
 * nothing has changed does not run: where the input of some ranks alone changes between updates,
 * call Modified() on all, or the others wait forever.
 *
 * @sa
 * vtkMeshDistanceField vtkMedialAxis
 */

#ifndef vtkDistributedFieldAlgorithm_h
#define vtkDistributedFieldAlgorithm_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters
#include "vtkMeshFieldAlgorithm.h"
#include "vtkSmartPointer.h" // For Controller

class vtkMultiProcessController;

class VTKMEDIALFILTERS_EXPORT vtkDistributedFieldAlgorithm : public vtkMeshFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for obtaining type information, and printing.
   */
  vtkTypeMacro(vtkDistributedFieldAlgorithm, vtkMeshFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Whether the inputs of all processes together are the surface, instead of each of them. It must
   * be the same on all. Default is off.
   */
  vtkMedialDistributedInputMacro();
  ///@}

  ///@{
  /**
   * The processes among which the surface is distributed; null is a process on its own. Used when
   * DistributedInput is on. Default is vtkMultiProcessController::GetGlobalController() of the time
   * when the filter was made.
   */
  vtkMedialControllerMacro();
  ///@}

protected:
  vtkDistributedFieldAlgorithm();
  ~vtkDistributedFieldAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkTypeBool DistributedInput = false;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  vtkDistributedFieldAlgorithm(const vtkDistributedFieldAlgorithm&) = delete;
  void operator=(const vtkDistributedFieldAlgorithm&) = delete;
};

#endif
