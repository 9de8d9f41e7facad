/**
 * @class   vtkMeshPointDistance
 * @brief   exact signed distances of the points of any data set from a surface
 *
 * vtkMeshPointDistance gives every point of its first input the distance to the closest point of a
 * surface, its second input, exact in double precision and without a grid: for probes along a path,
 * for the points of a scan, of an unstructured grid or of an image, and for the deviation of one
 * mesh from another.
 *
 * The output is the first input with these point data arrays:
 * - Distance (double, world units, the active scalars): negative inside; unsigned if SignMethod
 *   says so or the surface does not define an inside;
 * - ClosestPoint (double x 3): the closest point of the surface;
 * - ClosestCell (vtkIdType): the id of a cell of the surface that contains it;
 * - ClosestFeature (unsigned char): what it lies on, 0 for a vertex, 1 for an edge, 2 for a face;
 * - Direction (double x 3): the unit vector from the point to its closest point; zero where the
 *   point is on the surface.
 *
 * Of several closest points at the same distance, one on a face comes before one on an edge, and
 * one on an edge before one at a vertex; among equals, that of the first cell. The result depends
 * neither on the number of threads nor on which points are computed together.
 *
 * @par Field data:
 * The output has field data arrays of one tuple: SignMethod and SignReason (strings), what was used
 * and why; and of the points MinDistance and MaxDistance, with their signs, and of the magnitudes
 * MeanDistance, RMSDistance, MedianDistance and Percentile95Distance, which 5 % of the points
 * exceed (double, world units, NaN without points).
 *
 * @par Input:
 * Port 0 takes any vtkDataSet; each block of a composite one is computed on its own. Port 1 takes
 * any vtkPolyData, as vtkMeshFieldAlgorithm does: polygons, strips, lines and vertices, closed or
 * not. What is prepared for the surface is kept until it changes, so moving the points costs
 * little.
 *
 * @par Errors and abort:
 * As for vtkMedialPolyDataAlgorithm. A point whose coordinates are not finite is an error that
 * names it.
 *
 * @par Time:
 * The output has the time steps of both inputs; each is asked for the time that is requested.
 *
 * @par Parallel pipelines:
 * Points are split as the pipeline asks; every piece asks for the whole surface.
 *
 * @sa
 * vtkMeshDistanceField vtkMedialThickness vtkImplicitPolyDataDistance
 */

#ifndef vtkMeshPointDistance_h
#define vtkMeshPointDistance_h

#include "vtkDataSetAlgorithm.h"
#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters

#include <memory> // For std::unique_ptr

class vtkAlgorithmOutput;
class vtkPolyData;

class VTKMEDIALFILTERS_EXPORT vtkMeshPointDistance : public vtkDataSetAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMeshPointDistance* New();
  vtkTypeMacro(vtkMeshPointDistance, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The surface from which distances are measured: port 1. SetSurfaceData() makes no pipeline
   * connection.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* output);
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /**
   * How inside, where the distance is negative, is told from outside; the magnitude of the distance
   * does not depend on it. SIGN_WINDING: generalised winding numbers, for any mesh of triangles,
   * also with holes, and with parts that overlap, touch or face different ways. SIGN_AUTO:
   * SIGN_WINDING, but SIGN_NONE if the mesh does not define an inside, by the rules of
   * vtkMeshFieldAlgorithm. SIGN_NONE: unsigned. SIGN_PSEUDONORMAL: angle-weighted pseudonormals,
   * wrong where parts overlap or touch; an error where the mesh is open or not consistently
   * oriented. Default is SIGN_AUTO.
   */
  vtkMedialSignMethodMacro();
  ///@}

  ///@{
  /**
   * Number of CPU threads to use, >= 0; 0 uses all cores. The result does not depend on it.
   * Default is 0.
   */
  vtkMedialThreadsMacro();
  ///@}

protected:
  vtkMeshPointDistance();
  ~vtkMeshPointDistance() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int SignMethod = SIGN_AUTO;
  int NumberOfThreads = 0;

private:
  vtkMeshPointDistance(const vtkMeshPointDistance&) = delete;
  void operator=(const vtkMeshPointDistance&) = delete;

  void Execute(vtkDataSet* points, vtkPolyData* surface, vtkDataSet* output);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
