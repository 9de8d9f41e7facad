/**
 * @class   vtkMedialSkeleton
 * @brief   network of curves within a solid: centrelines, without seeds
 *
 * vtkMedialSkeleton computes the network of curves within a mesh: the centreline of a tube, the
 * middle line of a plate, one branch for every limb. It makes the medial axis with the topology of
 * the solid, and burns its sheets from their rims at unit speed (erosion thickness: Yan, Sykes,
 * Chambers, Letscher, Ju, 2016). What burns last are the curves. They have the components and the
 * loops of the solid at the resolution of the grid. A branch ends where the radius begins to fall
 * by half of the length or more: at a flat cap, one radius away from it; at an open end, at the
 * opening.
 *
 * The output is a vtkPolyData with points in double precision. Each branch is a polyline; branches
 * that meet share a point. A body that shrinks to a point is a vertex. Point data arrays: Radius,
 * the exact distance to the mesh (float64, world units, the active scalars); ArcLength, from the
 * start of the branch (float64, world units; 0 at junctions); Degree (int32: 1 at a free end, 2
 * within a branch, 3 and more at a junction, 0 for a single point); Tangent, a unit vector along
 * the branch (float64 x 3; zero at junctions). Cell data arrays: BranchId (int32, 0 for the
 * longest); Kind (unsigned char: 0 from a junction to a free end, 1 between junctions, 2 closed, 3
 * with two free ends or a single point); Length, MeanRadius, MinRadius and MaxRadius (float64,
 * world units).
 *
 * vtkMeshFieldAlgorithm documents the parameters of the grid and of the distance field, the input,
 * the field data, errors and abort. The Generate parameters have no effect, as there is no image.
 * The field data has four more arrays here: Branches, Junctions, Components and Loops, their
 * numbers. Input without an inside, such as a mesh with large holes, is an error.
 *
 * @par Parameter tuning:
 * The voxels must be smaller than the radius of the thinnest branch; AutomaticResolution sees to
 * that. MinimumBranch 1 leaves a smooth tube a single branch; larger values remove more short
 * branches. For noisy scans set MinimumLambda to three times the height of the noise.
 *
 * @par Parallel pipelines:
 * The output is not split: piece 0 is all of it, every other piece is empty.
 *
 * @sa
 * vtkMedialAxis vtkMedialCurves vtkMeshFieldAlgorithm
 */

#ifndef vtkMedialSkeleton_h
#define vtkMedialSkeleton_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMeshFieldAlgorithm.h"

class vtkPolyData;

class VTKMEDIALFILTERS_EXPORT vtkMedialSkeleton : public vtkMeshFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialSkeleton* New();
  vtkTypeMacro(vtkMedialSkeleton, vtkMeshFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Minimum separation angle of the axis in degrees, in the open interval (0, 180). Smaller values
   * keep more of the sheets that burn, which is needed for branches into their corners.
   * Default is 60.
   */
  vtkMedialAngleMacro();
  ///@}

  ///@{
  /**
   * Minimum lambda of the axis in world units, at least 0: half the distance between the two
   * closest points. This removes what noise of this size causes, and the branches of tubes thinner
   * than this. Default is 0.
   */
  vtkSetMacro(MinimumLambda, double);
  vtkGetMacro(MinimumLambda, double);
  ///@}

  ///@{
  /**
   * Whether the thinnest branch decides on the number of grid points along the longest axis of the
   * padded bounds instead of Resolution: 128 to 512 of them, so that four lie in its radius. The
   * filter makes skeletons on coarser grids first to find it. If it needs more than 512, a
   * vtkWarningMacro says so, once per process. Used when GridMode is RESOLUTION. Default is off.
   */
  vtkSetMacro(AutomaticResolution, vtkTypeBool);
  vtkGetMacro(AutomaticResolution, vtkTypeBool);
  vtkBooleanMacro(AutomaticResolution, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Minimum length of a branch with a free end, as a multiple of the radius where it leaves the
   * others, at least 0. In a sheet, the distance from the rim counts instead of the radius.
   * Junctions closer together than this become one. Loops stay. Default is 1.
   */
  vtkSetMacro(MinimumBranch, double);
  vtkGetMacro(MinimumBranch, double);
  ///@}

  ///@{
  /**
   * Whether branches are smooth curves through the middle of the solid. Otherwise they run from
   * point to point of the axis, and zigzag by a voxel. Default is on.
   */
  vtkSetMacro(Smooth, vtkTypeBool);
  vtkGetMacro(Smooth, vtkTypeBool);
  vtkBooleanMacro(Smooth, vtkTypeBool);
  ///@}

  /**
   * The skeleton.
   */
  vtkPolyData* GetOutput();

protected:
  vtkMedialSkeleton();
  ~vtkMedialSkeleton() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkTypeBool AutomaticResolution = false;
  double Angle = 60.0;
  double MinimumLambda = 0.0;
  double MinimumBranch = 1.0;
  vtkTypeBool Smooth = true;

private:
  void Execute(vtkPolyData* input, vtkPolyData* output);

  vtkMedialSkeleton(const vtkMedialSkeleton&) = delete;
  void operator=(const vtkMedialSkeleton&) = delete;
};

#endif
