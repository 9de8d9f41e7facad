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
 * With DistributedInput each rank computes its extent of the field of the whole surface, as
 * vtkDistributedFieldAlgorithm says. ClosestCell is the number of the cell in the whole: its global
 * id where all pieces have some.
 *
 * Ranks exchange the bounds of their input where the pipeline asks for information, unless GridMode
 * is EXPLICIT. A rank that is asked for it again, because something upstream changed there alone,
 * waits until the others are asked for something: give such a filter a reader of its own, which
 * does not serve others with other pieces, or use an explicit grid. A rank whose input fails
 * without the others being asked for information leaves them waiting.
 *
 * @sa
 * vtkMedialAxis vtkDistributedFieldAlgorithm vtkImplicitPolyDataDistance
 */

#ifndef vtkMeshDistanceField_h
#define vtkMeshDistanceField_h

#include "vtkDistributedFieldAlgorithm.h"
#include "vtkMedialFiltersModule.h" // For export macro

class vtkImageData;

class VTKMEDIALFILTERS_EXPORT vtkMeshDistanceField : public vtkDistributedFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMeshDistanceField* New();
  vtkTypeMacro(vtkMeshDistanceField, vtkDistributedFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * The distance field, output port 0.
   */
  vtkImageData* GetOutput();

protected:
  vtkMeshDistanceField();
  ~vtkMeshDistanceField() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  void ComputeOfWhole(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void ComputeOfPieces(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  vtkMeshDistanceField(const vtkMeshDistanceField&) = delete;
  void operator=(const vtkMeshDistanceField&) = delete;
};

#endif
