/**
 * @class   vtkMedialAxis
 * @brief   medial axis of a mesh, simplified by separation angle
 *
 * vtkMedialAxis computes the medial axis of a mesh: the points with two or more nearest points on
 * it. It keeps the part whose separation angle, the angle between the directions to two nearest
 * points, is at least Angle (Foskey, Lin, Manocha: Efficient Computation of a Simplified Medial
 * Axis, 2003), from the exact distance field on a regular grid. Points have sub-voxel positions.
 *
 * Output port 0 is the axis, a vtkPolyData with points in double precision. Its point data arrays:
 * Radius, the distance to the mesh (float32, world units, the active scalars); SeparationAngle
 * (float32, degrees); Lambda, Radius times the sine of half the separation angle (float32, world
 * units); ClosestPointA and ClosestPointB, two nearest points on the mesh (float32 x 3, world
 * coordinates). Voxel faces are selected by the directions at grid points, while SeparationAngle is
 * that at the point itself, so some of theirs are below Angle; no others are, unless Topology keeps
 * them.
 *
 * With MaximumNumberOfSpheres the axis is made compact: at most so many points, whose balls, with
 * the cones and slabs between those of a line or triangle, approximate the shape (quadric edge
 * collapse, after Li and others: Q-MAT, 2015). Radius then is that of the best ball,
 * which may reach a little beyond the surface; SeparationAngle and the closest points are those of
 * the point of the full axis next to it.
 *
 * Output port 1 is the distance field on the same grid, a vtkImageData as vtkMeshDistanceField
 * makes it. It is empty unless GenerateDistanceField is on.
 *
 * vtkMeshFieldAlgorithm documents the parameters of the grid and of the distance field, the input,
 * errors and abort.
 *
 * @par Parameter tuning:
 * Angle 60 shows the sheets that carry the shape and drops most noise; 90 and more leave the thick
 * parts, 30 and less reach for the convex edges and show the noise of scans. A sheet is found where
 * the voxels are smaller than the features that it separates. Near curves and points of the axis
 * the output is a band of width h / (2 sin(Angle / 2)) for voxels of size h. An axis that is a
 * point, as of a ball, is sure to be found only for Angle <= 70.
 *
 * @par Parallel pipelines:
 * Neither output is split: piece 0 is all of it, every other piece is empty. Distance fields in
 * parts come from vtkMeshDistanceField.
 *
 * @sa
 * vtkMeshDistanceField vtkMeshFieldAlgorithm
 */

#ifndef vtkMedialAxis_h
#define vtkMedialAxis_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMeshFieldAlgorithm.h"

class vtkImageData;
class vtkPolyData;

class VTKMEDIALFILTERS_EXPORT vtkMedialAxis : public vtkMeshFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialAxis* New();
  vtkTypeMacro(vtkMedialAxis, vtkMeshFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * The side of the surface that the axis is wanted for.
   */
  enum Sides
  {
    INTERIOR = 0,
    EXTERIOR = 1,
    BOTH = 2
  };

  /**
   * What the axis is made of.
   */
  enum Representations
  {
    SURFACE = 0,
    FACES = 1,
    POINTS = 2
  };

  /**
   * Whether the axis must have the topology of the solid.
   */
  enum Topologies
  {
    SELECTED = 0,
    PRESERVE = 1
  };

  ///@{
  /**
   * Least separation angle of the points of the axis in degrees, in the open interval (0, 180).
   * Smaller values keep more of the axis and more noise. Default is 60.
   */
  vtkSetMacro(Angle, double);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /**
   * Least lambda of the points of the axis, in world units, at least 0: half the distance of the
   * two closest points. It takes away what noise of that size makes, and also what lies behind
   * walls thinner than twice as much. Default is 0.
   */
  vtkSetMacro(MinimumLambda, double);
  vtkGetMacro(MinimumLambda, double);
  ///@}

  ///@{
  /**
   * Least radius of the medial balls, in world units, at least 0. Default is 0.
   */
  vtkSetMacro(MinimumRadius, double);
  vtkGetMacro(MinimumRadius, double);
  ///@}

  ///@{
  /**
   * The side of the surface that the axis is wanted for: INTERIOR, where the distance is negative,
   * EXTERIOR, where it is positive, or BOTH. An unsigned distance, as of an open mesh, knows no
   * sides: the axis is that of BOTH then, and GetUsedSide() says so. Default is INTERIOR.
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
   * What the axis is made of. SURFACE: a mesh with at most one point a voxel, quads and triangles,
   * and lines and vertices where the axis is thinner than a sheet. FACES: the voxel faces between
   * sample points on either side of the axis. POINTS: one point for each such face, on the bisector
   * of the two nearest sites. Default is SURFACE.
   */
  vtkSetMacro(Representation, int);
  vtkGetMacro(Representation, int);
  void SetRepresentationToSurface() { this->SetRepresentation(SURFACE); }
  void SetRepresentationToFaces() { this->SetRepresentation(FACES); }
  void SetRepresentationToPoints() { this->SetRepresentation(POINTS); }
  const char* GetRepresentationAsString();
  ///@}

  ///@{
  /**
   * Most points of the axis; 0 for no limit, else >= 1. Components that Angle has cut apart are
   * joined where their balls overlap, and edges collapsed, the least error first, until the number
   * is reached; holes and components of the shape stay as long as it allows. A few hundred describe
   * most shapes. Not for POINTS, which have no cells. Default is 0.
   */
  vtkSetMacro(MaximumNumberOfSpheres, int);
  vtkGetMacro(MaximumNumberOfSpheres, int);
  ///@}

  ///@{
  /**
   * Whether the axis must have the topology of the solid. SELECTED: what Angle selects, in as many
   * pieces as that is. PRESERVE: whatever Angle is, the axis has as many pieces, tunnels and
   * cavities, and so the Euler characteristic and the genus, as the solid at the resolution of the
   * grid: the voxels of the side are thinned from the surface on without cutting or piercing, and
   * what Angle selects as sheets stays. Curves join the sheets and stand for thin round parts, as
   * lines. Each side is thinned by itself, an unsigned one is the whole grid. PRESERVE takes 10
   * bytes a grid point of the whole grid, and Representation SURFACE or FACES.
   * Default is SELECTED.
   */
  vtkSetMacro(Topology, int);
  vtkGetMacro(Topology, int);
  void SetTopologyToSelected() { this->SetTopology(SELECTED); }
  void SetTopologyToPreserve() { this->SetTopology(PRESERVE); }
  const char* GetTopologyAsString();
  ///@}

  ///@{
  /**
   * Whether output port 1 is the distance field on the whole grid, from the same run and with the
   * arrays that the Generate flags ask for. Off, the port is an empty image, and the arrays of the
   * grid are never held in memory. Default is off.
   */
  vtkSetMacro(GenerateDistanceField, vtkTypeBool);
  vtkGetMacro(GenerateDistanceField, vtkTypeBool);
  vtkBooleanMacro(GenerateDistanceField, vtkTypeBool);
  ///@}

  /**
   * The side of the last execution: BOTH where the distance is unsigned, else Side. BOTH before the
   * first execution and after a failed one.
   */
  int GetUsedSide();

  /**
   * The medial axis, output port 0.
   */
  vtkPolyData* GetOutput();

  /**
   * The distance field, output port 1; empty unless GenerateDistanceField is on.
   */
  vtkImageData* GetDistanceField();

protected:
  vtkMedialAxis();
  ~vtkMedialAxis() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  double Angle = 60.0;
  double MinimumLambda = 0.0;
  double MinimumRadius = 0.0;
  int Side = INTERIOR;
  int Representation = SURFACE;
  int MaximumNumberOfSpheres = 0;
  int Topology = SELECTED;
  vtkTypeBool GenerateDistanceField = false;

private:
  vtkMedialAxis(const vtkMedialAxis&) = delete;
  void operator=(const vtkMedialAxis&) = delete;
};

#endif
