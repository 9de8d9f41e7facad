/**
 * @class   vtkMedialReconstruction
 * @brief   surface of the solid that a medial axis describes
 *
 * vtkMedialReconstruction makes the surface of the union of the balls of a medial axis, and, with
 * Interpolate, of what lies between them: the convex hulls of two balls joined by a line or an edge
 * of a polygon (cones) and of three joined by a triangle (wedges). It computes the signed distance
 * to them exactly at the points of a regular grid, near the surface, and contours it with
 * vtkFlyingEdges3D.
 *
 * @par Input:
 * A vtkPolyData as vtkMedialAxis makes it: points with the point data array Radius (any numeric
 * type, one component, world units) and vertices, lines, polygons and strips over them. Every point
 * is a ball, whether a cell uses it or not. A quad is two triangles; polygons of more corners are
 * fans.
 *
 * @par Output:
 * Triangles, closed, points in double precision, with normals that point outwards (array Normals).
 * Details thinner than a voxel may be missing. Balls of radius 0 have no inside, so they add
 * nothing.
 *
 * @par Errors:
 * Input without points, a missing or unsuitable array Radius, a radius that is negative or not
 * finite, a Resolution outside its range, and a grid larger than the available memory.
 * vtkMedialPolyDataAlgorithm documents how errors are reported, abort and parallel pipelines.
 *
 * @par Parallel pipelines:
 * With DistributedInput each rank makes its part of the surface, whatever piece is asked for: the
 * triangles in its part of the grid. Together they are, bit for bit, those that one process makes
 * of the whole axis, each on one rank; points on a cut are in the parts of both sides, with the
 * same normals. Parts may be empty. Of the axis each rank gets what can matter in its part, and no
 * rank ever holds all of it. Balls and cells that are in several pieces, as points on cuts are,
 * change nothing. With DistributedInput an input may also be a vtkUnstructuredGrid, or blocks, of
 * which the points that cells use count; pieces may be empty. All ranks must update the filter
 * together, with the same parameters: vtkDistributedFieldAlgorithm says more of that.
 *
 * @sa
 * vtkMedialAxis vtkMedialPolyDataAlgorithm vtkDistributedFieldAlgorithm
 */

#ifndef vtkMedialReconstruction_h
#define vtkMedialReconstruction_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters
#include "vtkMedialPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For Controller

class vtkMultiProcessController;

class VTKMEDIALFILTERS_EXPORT vtkMedialReconstruction : public vtkMedialPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialReconstruction* New();
  vtkTypeMacro(vtkMedialReconstruction, vtkMedialPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Number of grid points along the longest axis of the balls' bounds, which are padded by 5 % of
   * their diagonal, in [2, 8192]. Where the surface is smooth, its error falls with the square of
   * the spacing. Default is 128.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Whether cones and wedges between the balls belong to the solid. If off, the solid is the union
   * of the balls alone, which is bumpy where they lie apart. Default is on.
   */
  vtkSetMacro(Interpolate, vtkTypeBool);
  vtkGetMacro(Interpolate, vtkTypeBool);
  vtkBooleanMacro(Interpolate, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the inputs of all processes together are the axis, instead of each of them. It must be
   * the same on all. Default is off.
   */
  vtkMedialDistributedInputMacro();
  ///@}

  ///@{
  /**
   * The processes among which the axis is distributed; null is a process on its own. Used when
   * DistributedInput is on. Default is vtkMultiProcessController::GetGlobalController() of the time
   * when the filter was made.
   */
  vtkMedialControllerMacro();
  ///@}

protected:
  vtkMedialReconstruction();
  ~vtkMedialReconstruction() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  void Execute(const std::vector<vtkPolyData*>& inputs,
    const std::vector<vtkPolyData*>& outputs) override;

  int Resolution = 128;
  vtkTypeBool Interpolate = true;
  vtkTypeBool DistributedInput = false;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  void ExecutePieces(vtkDataObject* input, vtkPolyData* output);

  vtkMedialReconstruction(const vtkMedialReconstruction&) = delete;
  void operator=(const vtkMedialReconstruction&) = delete;
};

#endif
