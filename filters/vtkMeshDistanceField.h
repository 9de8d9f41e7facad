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
 * @sa
 * vtkMedialAxis vtkMeshFieldAlgorithm vtkImplicitPolyDataDistance
 */

#ifndef vtkMeshDistanceField_h
#define vtkMeshDistanceField_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMeshFieldAlgorithm.h"

class vtkImageData;

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

protected:
  vtkMeshDistanceField();
  ~vtkMeshDistanceField() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshDistanceField(const vtkMeshDistanceField&) = delete;
  void operator=(const vtkMeshDistanceField&) = delete;
};

#endif
