/**
 * @class   vtkMeshDistanceField
 * @brief   exact distance field of a mesh on a regular grid
 *
 * vtkMeshDistanceField computes the exact distance from every point of a regular grid to the
 * closest point of a mesh, and which point, cell and feature that is. The method is linear
 * factorisation (Sud, Govindaraju, Gayle, Manocha: Interactive 3D Distance Field Computation using
 * Linear Factorization, I3D 2006).
 *
 * The output is a vtkImageData with the point data array Distance as its active scalars (float32,
 * world units, negative inside where the distance is signed) and, unless switched off,
 * ClosestPoint (float32 x 3, world coordinates), ClosestCell (vtkIdType), ClosestFeature (uint8: 0
 * vertex, 1 edge, 2 face) and ClosestSite (int32). vtkMeshFieldAlgorithm documents the parameters,
 * the input, these arrays and those of the field data, errors and abort.
 *
 * @par Extents:
 * The filter computes the requested update extent and nothing else, so that parts of a grid can be
 * streamed or distributed over processes. Distances do not depend on the extent; ids and closest
 * points do only between sites at equal distance.
 *
 * @par Several processes:
 * Unless DistributedInput is on, every process (rank) needs the whole surface and computes its part
 * for itself. With DistributedInput the inputs of all ranks together are the surface, and no rank
 * ever holds it: each computes its extent of the field of the whole, bit for bit what one process
 * computes by ENGINE_PROCESSOR. An input may then also be a vtkUnstructuredGrid of triangles and
 * polygons, or blocks of both kinds, as parallel readers and vtkRedistributeDataSetFilter deliver
 * them; ghost cells are left out, and pieces may be empty. Points whose coordinates have the same
 * bits are one, and so are triangles with the same corners. Global ids of cells and points number
 * them in the whole, where all pieces have some: ClosestCell then is such an id. Otherwise cells
 * are numbered one piece after the other.
 *
 * The surface must be an oriented manifold of triangles, closed or open, SignMethod SIGN_NONE or
 * SIGN_PSEUDONORMAL, and Engine ENGINE_AUTO or ENGINE_PROCESSOR. The field data have no arrays of
 * the mesh, but OwnTriangles, HeldTriangles and BytesSent (vtkIdType): the triangles of the surface
 * over the number of ranks, about; those that a rank had to hold for its extent; what it sent.
 *
 * All ranks must update the filter together, with the same parameters. What fails on one rank fails
 * on all, with a message that names the rank; so do parameters that differ. Ranks exchange the
 * bounds of their input where the pipeline asks for information, unless GridMode is EXPLICIT. A
 * rank that is asked for it again, because something upstream changed there alone, waits until the
 * others are asked for something: give such a filter a reader of its own, which does not serve
 * others with other pieces, or use an explicit grid. A rank whose input fails without the others
 * being asked for information leaves them waiting.
 *
 * @sa
 * vtkMedialAxis vtkMeshFieldAlgorithm vtkImplicitPolyDataDistance
 */

#ifndef vtkMeshDistanceField_h
#define vtkMeshDistanceField_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMeshFieldAlgorithm.h"
#include "vtkSmartPointer.h" // For Controller

class vtkImageData;
class vtkMultiProcessController;

class VTKMEDIALFILTERS_EXPORT vtkMeshDistanceField : public vtkMeshFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMeshDistanceField* New();
  vtkTypeMacro(vtkMeshDistanceField, vtkMeshFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * The distance field, output port 0.
   */
  vtkImageData* GetOutput();

  ///@{
  /**
   * Whether the inputs of all processes together are the surface, instead of each of them. It must
   * be the same on all. SignMethod then must be SIGN_NONE or SIGN_PSEUDONORMAL. Default is off.
   */
  vtkSetMacro(DistributedInput, vtkTypeBool);
  vtkGetMacro(DistributedInput, vtkTypeBool);
  vtkBooleanMacro(DistributedInput, vtkTypeBool);
  ///@}

  ///@{
  /**
   * The processes among which the surface is distributed; null is a process on its own. Used when
   * DistributedInput is on. Default is vtkMultiProcessController::GetGlobalController() of the time
   * when the filter was made.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  /**
   * What the input may be follows from DistributedInput.
   */
  void Modified() override;

protected:
  vtkMeshDistanceField();
  ~vtkMeshDistanceField() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkTypeBool DistributedInput = false;

private:
  void ComputeOfWhole(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void ComputeOfPieces(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  vtkSmartPointer<vtkMultiProcessController> Controller;

  vtkMeshDistanceField(const vtkMeshDistanceField&) = delete;
  void operator=(const vtkMeshDistanceField&) = delete;
};

#endif
