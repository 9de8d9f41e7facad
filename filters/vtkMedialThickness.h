/**
 * @class   vtkMedialThickness
 * @brief   wall thickness of a surface at its points, by touching medial balls
 *
 * vtkMedialThickness gives every point of a surface twice the radius of the medial ball that
 * touches it: how thick the solid is there or, for the exterior, how far it is to what is opposite.
 * The ray from the point against its angle-weighted normal is followed to the first place whose
 * closest surface point is seen under Angle or more away from the start; the radius is the distance
 * there. This is exact for the mesh as it is, in double precision, and needs neither a grid nor
 * OpenGL. It is the iteration of shrinking balls (Ma, Bae, Choi: 3D Medial Point Approximation
 * Using Normal Vectors, 2012) with exact closest points of the mesh.
 *
 * The output is the input with the point data array Thickness (float32, world units, the active
 * scalars). It is 0 where a sheet of the medial axis runs into the surface: on edges that are
 * convex seen from the wanted side and bend by Angle or more, and on tips as sharp as that. It is
 * NaN where there is no such ball: for exteriors of convex parts, where an open surface has nothing
 * opposite, and at points without a normal, as those of no triangle.
 *
 * @par Input:
 * Any vtkPolyData, as for vtkMedialAxis: polygons, triangle strips, lines and vertices, closed or
 * not. All cells limit the balls; points of polygons and strips have values. Interior is behind the
 * faces, by their own orientation; a closed, consistently oriented surface whose faces point
 * inwards is turned round.
 *
 * @par Parameter tuning:
 * Values are at points only. The points of a coarse CAD mesh lie on sharp edges, where they are 0:
 * put vtkAdaptiveSubdivisionFilter (or vtkLinearSubdivisionFilter) in front to see what is between.
 *
 * @par Errors:
 * A parameter outside its range and input that cannot be used are reported by one vtkErrorMacro
 * with the value and the allowed range; GetErrorCode() then is one of
 * vtkMeshFieldAlgorithm::ErrorCodes, the output is empty and the request ends as one of
 * vtkMeshFieldAlgorithm. Parameters are checked when the filter executes.
 *
 * @par Abort:
 * As vtkMeshFieldAlgorithm: SetAbortExecute(1) from a ProgressEvent observer stops the execution,
 * the output is empty then and GetErrorCode() is CancelledError.
 *
 * @par Parallel pipelines:
 * The output is not split: piece 0 is all of it, every other piece is empty.
 *
 * @sa
 * vtkMedialAxis vtkMeshDistanceField
 */

#ifndef vtkMedialThickness_h
#define vtkMedialThickness_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKMEDIALFILTERS_EXPORT vtkMedialThickness : public vtkPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialThickness* New();
  vtkTypeMacro(vtkMedialThickness, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * The side of the surface that the thickness is wanted for.
   */
  enum Sides
  {
    INTERIOR = 0,
    EXTERIOR = 1,
    BOTH = 2
  };

  ///@{
  /**
   * Least separation angle of the balls that count in degrees, in the open interval (0, 180).
   * Places where two nearest points are seen under less, as between the facets of a curved surface,
   * are passed over. Default is 60.
   */
  vtkSetMacro(Angle, double);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /**
   * The side of the surface that the thickness is wanted for: INTERIOR, how thick the solid is,
   * EXTERIOR, how far it is to what is opposite (clearance), or BOTH, the smaller of the two.
   * Default is INTERIOR.
   */
  vtkSetMacro(Side, int);
  vtkGetMacro(Side, int);
  void SetSideToInterior() { this->SetSide(INTERIOR); }
  void SetSideToExterior() { this->SetSide(EXTERIOR); }
  void SetSideToBoth() { this->SetSide(BOTH); }
  const char* GetSideAsString();
  ///@}

  ///@{
  /**
   * Number of CPU threads to use, >= 0; 0 uses all cores. The result does not depend on it.
   * Default is 0.
   */
  vtkSetMacro(NumberOfThreads, int);
  vtkGetMacro(NumberOfThreads, int);
  ///@}

  ///@{
  /**
   * Figures of the last execution: the least, the median and the greatest thickness in world units,
   * NaN where no point has one, and the share of the points without one, in [0, 1]. Points that are
   * at the same place count once, points of no cell not at all. Zero before the first execution and
   * after a failed one.
   */
  vtkGetMacro(MinThickness, double);
  vtkGetMacro(MedianThickness, double);
  vtkGetMacro(MaxThickness, double);
  vtkGetMacro(ShareWithout, double);
  ///@}

protected:
  vtkMedialThickness();
  ~vtkMedialThickness() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Angle = 60.0;
  int Side = INTERIOR;
  int NumberOfThreads = 0;
  double MinThickness = 0.0;
  double MedianThickness = 0.0;
  double MaxThickness = 0.0;
  double ShareWithout = 0.0;

private:
  void Execute(vtkPolyData* input, vtkPolyData* output);
  void ForgetFigures();

  vtkMedialThickness(const vtkMedialThickness&) = delete;
  void operator=(const vtkMedialThickness&) = delete;
};

#endif
