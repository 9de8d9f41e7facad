/**
 * @class   vtkMedialAxis
 * @brief   medial axis of a mesh, simplified by separation angle
 *
 * vtkMedialAxis computes the medial axis of a mesh: the points with two or more closest points on
 * the mesh. It keeps the part whose separation angle, the angle between the directions to two
 * closest points, is at least Angle (Foskey, Lin, Manocha: Efficient Computation of a Simplified
 * Medial Axis, 2003). It works from the exact distance field on a regular grid. Points have
 * sub-voxel positions.
 *
 * Output port 0 is the axis, a vtkPolyData with points in double precision. Its point data arrays:
 * Radius, the distance to the mesh (float32, world units, the active scalars); SeparationAngle
 * (float32, degrees, in [0, 180]); Lambda, Radius times the sine of half the separation angle
 * (float32, world units); ClosestPointA and ClosestPointB, two closest points on the mesh (float32
 * x 3, world coordinates); AxisFeature, where the point lies on the axis (unsigned char: 0 inside a
 * sheet, 1 on a rim, where a sheet ends, 2 on a seam, where sheets meet, 3 at a junction, 4 on a
 * curve, 5 alone). With Representation FACES the angle may be below Angle, since faces are selected
 * by the directions at grid points, and so it may where Topology keeps a point. With SURFACE it may
 * be as low as 0.8 Angle at single points between the facets of round walls, mostly on rims.
 *
 * With MaximumNumberOfSpheres the axis is made compact: it has at most that many points, whose
 * balls, with the cones between two of them on a line and the wedges between three on a triangle,
 * approximate the shape (edge contraction by quadrics, after Li and others: Q-MAT, 2015). Radius is
 * then that of the best ball, which may reach a little beyond the surface; SeparationAngle and the
 * closest points are those of the nearest point of the full axis.
 *
 * Output port 1 is the distance field on the same grid, a vtkImageData as vtkMeshDistanceField
 * makes it. It is empty unless GenerateDistanceField is on.
 *
 * vtkMeshFieldAlgorithm documents the parameters of the grid and of the distance field, the input,
 * the field data of both outputs, errors and abort. The field data has one more array here: Side (a
 * string, as GetSideAsString()), the side on which the axis lies: Both if the distance is unsigned.
 *
 * @par Parameter tuning:
 * Angle 60 shows the sheets that carry the shape and drops most noise; 90 and more leaves only the
 * thick parts; 30 and less reaches for the convex edges and shows the noise of scans. A sheet is
 * found if the voxels are smaller than the features that it separates. Near curves and points of
 * the axis the output is a band of width h / (2 sin(Angle / 2)) for voxels of size h. An axis that
 * is a single point, as that of a ball, is certain to be found only for Angle <= 70.
 *
 * @par Parallel pipelines:
 * Neither output is split: piece 0 is all of it, every other piece is empty. For a distance field
 * in pieces use vtkMeshDistanceField.
 *
 * @par Several processes:
 * With DistributedInput the axis comes in pieces as well: each rank has the cells of its part of
 * the grid, whatever piece is asked for. Where all ranks ask for the whole, piece 0 of 1, the first
 * has all of it and the others nothing: so filters that need the whole axis, such as
 * vtkMedialCurves and vtkMedialReconstruction, make the same of it. vtkGlobalPointIds and
 * vtkGlobalCellIds are the numbers that points and cells have in the axis of one process; points on
 * a cut are in several pieces, cells in one. GenerateDistanceField must be off. With
 * MaximumNumberOfSpheres the first rank has all of the axis, since a limit looks at the whole. With
 * Topology PRESERVE it thins the voxels of the whole grid, and takes 10 bytes for each.
 * vtkDistributedFieldAlgorithm says what the input may be.
 *
 * @sa
 * vtkMeshDistanceField vtkMeshFieldAlgorithm vtkDistributedFieldAlgorithm
 */

#ifndef vtkMedialAxis_h
#define vtkMedialAxis_h

#include "vtkDistributedFieldAlgorithm.h"
#include "vtkMedialFiltersModule.h" // For export macro

class vtkImageData;
class vtkPolyData;

class VTKMEDIALFILTERS_EXPORT vtkMedialAxis : public vtkDistributedFieldAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMedialAxis* New();
  vtkTypeMacro(vtkMedialAxis, vtkDistributedFieldAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

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
   * Minimum separation angle of the axis in degrees, in the open interval (0, 180). Smaller values
   * keep more of the axis and more noise. Default is 60.
   */
  vtkMedialAngleMacro();
  ///@}

  ///@{
  /**
   * Minimum lambda of the axis in world units, at least 0. Lambda is half the distance between the
   * two closest points. This removes the sheets that noise of this size causes, and those of walls
   * thinner than twice this. Default is 0.
   */
  vtkSetMacro(MinimumLambda, double);
  vtkGetMacro(MinimumLambda, double);
  ///@}

  ///@{
  /**
   * Minimum radius of the medial balls in world units, at least 0. Default is 0.
   */
  vtkSetMacro(MinimumRadius, double);
  vtkGetMacro(MinimumRadius, double);
  ///@}

  ///@{
  /**
   * The side of the surface on which the axis lies: INTERIOR, where the distance is negative,
   * EXTERIOR, where it is positive, or BOTH. An unsigned distance, as of an open mesh, has no
   * sides: the axis is then that of BOTH, and the field data array Side says so. Default is
   * INTERIOR.
   */
  vtkMedialSideMacro();
  ///@}

  ///@{
  /**
   * What the axis is made of. SURFACE: a mesh with at most one point per voxel, of quads and
   * triangles, and of lines and vertices where the axis is thinner than a sheet. FACES: the voxel
   * faces between neighbouring grid points on either side of the axis. POINTS: one point for each
   * such face, on the bisector of the two closest sites. Default is SURFACE.
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
   * Maximum number of points of the axis, >= 1, or 0 for no limit. Components that Angle has cut
   * apart are joined where their balls overlap; then edges are contracted, those with the smallest
   * error first, until the number is reached. Holes and components of the shape are kept as long as
   * the number allows. A few hundred points describe most shapes. Not for POINTS, which have no
   * cells. Default is 0.
   */
  vtkSetMacro(MaximumNumberOfSpheres, int);
  vtkGetMacro(MaximumNumberOfSpheres, int);
  ///@}

  ///@{
  /**
   * Whether the axis must have the topology of the solid. SELECTED: the axis is what Angle selects,
   * in as many components as that gives. PRESERVE: whatever Angle is, the axis has as many
   * components, tunnels and cavities, and so the Euler characteristic and the genus, as the solid
   * at the resolution of the grid. The voxels of the side are thinned from the surface inwards
   * without cutting or piercing, and the sheets that Angle selects stay. Curves join the sheets and
   * stand for thin round parts, as lines. Each side is thinned on its own; without a sign, the side
   * is the whole grid. PRESERVE takes 10 bytes per point of the whole grid, and needs
   * Representation SURFACE or FACES. Default is SELECTED.
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
   * arrays that the Generate flags ask for. Otherwise the port is an empty image, and the arrays of
   * the grid are never held in memory. Default is off.
   */
  vtkSetMacro(GenerateDistanceField, vtkTypeBool);
  vtkGetMacro(GenerateDistanceField, vtkTypeBool);
  vtkBooleanMacro(GenerateDistanceField, vtkTypeBool);
  ///@}

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
  void Execute(vtkPolyData* input, vtkInformationVector* outputVector);
  void ExecutePieces(vtkDataObject* input, vtkInformationVector* outputVector);

  vtkMedialAxis(const vtkMedialAxis&) = delete;
  void operator=(const vtkMedialAxis&) = delete;
};

#endif
