/**
 * @class   vtkMedialThickness
 * @brief   wall thickness of a surface at its points, by touching medial balls
 *
 * vtkMedialThickness gives every point of a surface twice the radius of the medial ball that
 * touches it: how thick the solid is there or, for the exterior, how wide the gap is. From each
 * point it follows the ray against the angle-weighted normal to the first place where the
 * directions to its closest surface point and to the start form an angle of Angle or more; the
 * radius is the distance there. This is exact for the mesh as it is, in double precision, and needs
 * neither a grid nor OpenGL. The iteration is that of shrinking balls (Ma, Bae, Choi: 3D Medial
 * Point Approximation Using Normal Vectors, 2012) with exact closest points of the mesh.
 *
 * The output is the input with the point data array Thickness (float32, world units, the active
 * scalars). It is 0 where a sheet of the medial axis runs into the surface: on edges that are
 * convex seen from the wanted side and bend by Angle or more, and on tips as sharp as that. It is
 * NaN where there is no such ball: outside of convex parts, where nothing is opposite an open
 * surface, and at points without a normal, such as those that belong to no triangle.
 *
 * @par Field data:
 * The output has field data arrays of one tuple (double): MinThickness, MedianThickness and
 * MaxThickness, in world units, NaN where no point has a thickness, and ShareWithout, the share of
 * the points without one, in [0, 1]. Points that are at the same place count once, points of no
 * cell not at all.
 *
 * @par Input:
 * Any vtkPolyData, as for vtkMedialAxis: polygons, triangle strips, lines and vertices, closed or
 * not. All cells limit the balls; points of polygons and strips have values. Interior is behind the
 * faces, by their own orientation; a closed, consistently oriented surface whose faces point
 * inwards is turned inside out first.
 *
 * @par Parameter tuning:
 * Values are at points only. The points of a coarse CAD mesh lie on sharp edges, where they are 0:
 * put vtkAdaptiveSubdivisionFilter (or vtkLinearSubdivisionFilter) in front to see values in
 * between.
 *
 * vtkMedialPolyDataAlgorithm documents errors, abort and parallel pipelines.
 *
 * @sa
 * vtkMedialAxis vtkMeshDistanceField vtkMedialPolyDataAlgorithm
 */

#ifndef vtkMedialThickness_h
#define vtkMedialThickness_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters
#include "vtkMedialPolyDataAlgorithm.h"

class VTKMEDIALFILTERS_EXPORT vtkMedialThickness : public vtkMedialPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialThickness* New();
  vtkTypeMacro(vtkMedialThickness, vtkMedialPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Minimum separation angle of the balls that count, in degrees, in the open interval (0, 180).
   * Places whose two closest points are seen under a smaller angle, as between the facets of a
   * curved surface, are passed over. Default is 60.
   */
  vtkMedialAngleMacro();
  ///@}

  ///@{
  /**
   * The side of the surface whose thickness is computed: INTERIOR, how thick the solid is,
   * EXTERIOR, how wide the gap is (clearance), or BOTH, the smaller of the two.
   * Default is INTERIOR.
   */
  vtkMedialSideMacro();
  ///@}

  ///@{
  /**
   * Number of CPU threads to use, >= 0; 0 uses all cores. The result does not depend on it.
   * Default is 0.
   */
  vtkMedialThreadsMacro();
  ///@}

protected:
  vtkMedialThickness();
  ~vtkMedialThickness() override;

  void Execute(const std::vector<vtkPolyData*>& inputs,
    const std::vector<vtkPolyData*>& outputs) override;

  double Angle = 60.0;
  int Side = INTERIOR;
  int NumberOfThreads = 0;

private:
  vtkMedialThickness(const vtkMedialThickness&) = delete;
  void operator=(const vtkMedialThickness&) = delete;
};

#endif
