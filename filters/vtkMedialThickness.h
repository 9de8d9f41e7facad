/**
 * @class   vtkMedialThickness
 * @brief wall thickness of a surface, by touching medial balls, by rays or between walls
 *
 * vtkMedialThickness gives every point of a surface twice the radius of the medial ball that
 * touches it: how thick the solid is there or, for the exterior, how wide the gap is. Method
 * chooses rays or walls instead. It also finds the regions where a solid is too thin or too thick.
 *
 * From each point it follows the ray against the angle-weighted normal to the first place where the
 * directions to its closest surface point and to the start form an angle of Angle or more; the
 * radius is the distance there. This is exact for the mesh as it is, in double precision, and needs
 * neither a grid nor OpenGL. The iteration is that of shrinking balls (Ma, Bae, Choi: 3D Medial
 * Point Approximation Using Normal Vectors, 2012) with exact closest points of the mesh.
 *
 * The output is the input with the point data array Thickness (float32, world units, the active
 * scalars). It is 0 where a sheet of the medial axis runs into the surface: on edges that are
 * convex seen from the chosen side and bend by Angle or more, and on tips as sharp as that. It is
 * NaN where there is no such ball: outside convex parts, where nothing is opposite an open surface,
 * and at points without a normal, such as those that belong to no triangle. With an Angle above 90
 * degrees it is NaN beside the edges of a box, where balls touch two sides at only 90 degrees.
 *
 * With CellValues, or a minimum or maximum, there is a cell data array Thickness as well: at the
 * centre of a triangle; for a larger cell the least of its triangles' values; NaN for lines and
 * vertices. With MaximumEdgeLength the output is the surface divided into smaller triangles, with
 * the cell data array InputCell.
 *
 * @par Regions:
 * With MinimumThickness or MaximumThickness the cell data array Region (int) is the number of the
 * region beyond the limits that a cell belongs to, from 1, or 0. Triangles that share a point are
 * one region. Places that are thin only because two sides meet at a convex edge or tip nearby do
 * not count: those whose two planes meet at more than 60 degrees, or at 15 or more if there is such
 * an edge. Field data arrays have one tuple for each region, the thinnest first, then the thickest:
 * RegionThin (1, or 0 if it is too thick), RegionValue (its least or largest thickness),
 * RegionPlace (where that is), and RegionArea. Limits on one side of an open surface are an error,
 * unless its holes are small compared with it.
 *
 * @par Field data:
 * The output has field data arrays of one tuple (double): MinThickness, Percentile5Thickness,
 * MedianThickness, Percentile95Thickness and MaxThickness, in world units, NaN where no point has a
 * thickness, and ShareWithout, the share of the points without one, in [0, 1]. No more than 5 % of
 * the values are smaller or larger than the percentiles. Points at the same place count once;
 * points of no cell do not count.
 *
 * @par Input:
 * Any vtkPolyData, as for vtkMedialAxis: polygons, triangle strips, lines and vertices, closed or
 * not. All cells limit the balls; points of polygons and strips have values. The interior is behind
 * the faces, by their own orientation; a closed, consistently oriented surface whose faces point
 * inwards is turned inside out first.
 *
 * @par Parameter tuning:
 * The points of a coarse CAD mesh lie on sharp edges, where values are 0: set MaximumEdgeLength to
 * see values in between.
 *
 * vtkMedialPolyDataAlgorithm documents errors, abort and parallel pipelines.
 *
 * @par Several processes:
 * With DistributedInput each rank keeps its piece, whatever piece is asked for: its cells in their
 * order, the points that they use, and their arrays. Thickness, Region and the field data are, bit
 * for bit, those that the whole surface has there in one process; of the field data only
 * OwnTriangles, HeldTriangles and BytesSent are the rank's own. With MaximumEdgeLength each rank
 * divides its piece, into the triangles that one process makes of it: vtkGlobalPointIds are the
 * numbers that points have there, and InputCell has the global ids of cells, or their numbers one
 * piece after the other. The surface must consist of triangles and polygons. An input may then also
 * be a vtkUnstructuredGrid, or blocks, which become one vtkPolyData with the arrays that all blocks
 * have. Cells that are ghosts, and those that an earlier rank or cell has with the same corners,
 * are left out. With WALL or limits the first rank brings together the triangles that are near
 * edges or beyond limits, and no others. vtkDistributedFieldAlgorithm says more of what the input
 * may be.
 *
 * @sa
 * vtkMedialAxis vtkMeshDistanceField vtkMedialPolyDataAlgorithm vtkDistributedFieldAlgorithm
 */

#ifndef vtkMedialThickness_h
#define vtkMedialThickness_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters
#include "vtkMedialPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // For Controller

class vtkMultiProcessController;

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

  /**
   * What thickness is.
   */
  enum Methods
  {
    BALL = 0,
    RAY = 1,
    WALL = 2
  };

  ///@{
  /**
   * What thickness is: BALL, twice the radius of the medial ball that touches the place, which
   * falls to 0 at convex edges, RAY, the distance along the inward normal to the opposite surface,
   * or WALL, the diameter of the ball that also touches the opposite wall, with a separation angle
   * of at least 120 degrees, and near edges that of the nearest place with such a ball. Default is
   * BALL.
   */
  vtkSetMacro(Method, int);
  vtkGetMacro(Method, int);
  void SetMethodToBall() { this->SetMethod(BALL); }
  void SetMethodToRay() { this->SetMethod(RAY); }
  void SetMethodToWall() { this->SetMethod(WALL); }
  const char* GetMethodAsString();
  ///@}

  ///@{
  /**
   * Whether cells have values too, at the centres of their triangles. It takes about three times as
   * long. Default is off.
   */
  vtkSetMacro(CellValues, bool);
  vtkGetMacro(CellValues, bool);
  vtkBooleanMacro(CellValues, bool);
  ///@}

  ///@{
  /**
   * Triangles are divided until no edge is longer than this, in world units, >= 0; 0 leaves the
   * surface as it is. Regions smaller than that may be missed. Default is 0.
   */
  vtkSetMacro(MaximumEdgeLength, double);
  vtkGetMacro(MaximumEdgeLength, double);
  ///@}

  ///@{
  /**
   * Regions that are thinner than this are found, in world units, >= 0; 0 sets no such limit. WALL
   * is the method for it, since the others are small near edges. Default is 0.
   */
  vtkSetMacro(MinimumThickness, double);
  vtkGetMacro(MinimumThickness, double);
  ///@}

  ///@{
  /**
   * Regions that are thicker than this are found, in world units, >= 0, above MinimumThickness; 0
   * sets no such limit. Default is 0.
   */
  vtkSetMacro(MaximumThickness, double);
  vtkGetMacro(MaximumThickness, double);
  ///@}

  ///@{
  /**
   * Number of CPU threads to use, >= 0; 0 uses all cores. The result does not depend on it.
   * Default is 0.
   */
  vtkMedialThreadsMacro();
  ///@}

  ///@{
  /**
   * Whether the inputs of all processes together are the surface, instead of each of them. It must
   * be the same on all. Default is off.
   */
  vtkMedialDistributedInputMacro();
  ///@}

  ///@{
  /**
   * The processes among which the surface is distributed; null is a process on its own. Used when
   * DistributedInput is on. Default is vtkMultiProcessController::GetGlobalController() of the time
   * when the filter was made.
   */
  vtkMedialControllerMacro();
  ///@}

protected:
  vtkMedialThickness();
  ~vtkMedialThickness() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  void Execute(const std::vector<vtkPolyData*>& inputs,
    const std::vector<vtkPolyData*>& outputs) override;

  double Angle = 60.0;
  int Side = INTERIOR;
  int Method = BALL;
  bool CellValues = false;
  double MaximumEdgeLength = 0.0;
  double MinimumThickness = 0.0;
  double MaximumThickness = 0.0;
  int NumberOfThreads = 0;
  vtkTypeBool DistributedInput = false;
  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  void ExecutePieces(vtkDataObject* input, vtkPolyData* output);

  vtkMedialThickness(const vtkMedialThickness&) = delete;
  void operator=(const vtkMedialThickness&) = delete;
};

#endif
