/**
 * @class   vtkMeshFieldAlgorithm
 * @brief   superclass of the filters that sample the distance field of a mesh on a regular grid
 *
 * vtkMeshFieldAlgorithm holds what vtkMeshDistanceField and vtkMedialAxis have in common: the grid,
 * the sign of the distance, the limits on resources, the choice of image arrays, and the field data
 * that describe an execution.
 *
 * @par Input:
 * Any vtkPolyData: triangles, quads, polygons, triangle strips, lines and vertices, in any mixture.
 * The surface need be neither closed nor manifold nor welded. Points that no cell uses are ignored.
 * Cell ids in the outputs are those of vtkPolyData: vertices, lines, polygons, strips. Cells
 * without points, and strips of fewer than three, are ignored.
 *
 * @par Coordinates:
 * All lengths are in world units, those of the input's points. Image outputs have point data on a
 * grid without rotation; the grid points are the image's points.
 *
 * @par Information:
 * Unless GridMode is EXPLICIT the grid of an image output follows from the bounds of the input, so
 * UpdateInformation() updates the input (never the field). If the input changes with time, the grid
 * is that of the time at which the information was made; use an explicit grid then. The welded mesh
 * is kept until the input changes: a new extent or parameter reuses it.
 *
 * @par Field data:
 * Every output that is not empty says how it was made, in field data arrays of one tuple each:
 * - SignMethod and Engine (strings): what was used, as GetSignMethodAsString() and
 *   GetEngineAsString() call it; never Auto.
 * - EngineNote (string): why ENGINE_AUTO left the work of a device to the processor; missing if it
 *   did not.
 * - SignReason (string): why this sign method was used, such as the number of imaginary lids over
 *   holes.
 * - GridOrigin and GridSpacing (double x 3, world units) and GridDimensions (int x 3): the whole
 *   grid, even if only part of it was computed.
 * - Triangles, Vertices, Components, DegenerateTriangles (vtkIdType): the mesh after points at the
 *   same place were welded and polygons cut into triangles; its connected components and its
 *   triangles without area.
 * - Closed (every edge has two triangles), Manifold, Oriented (consistently): unsigned char, 0 or
 *   1.
 * - Sites, GroupTests, SiteTests, CandidatePairs, Polygons, Fragments, Samples (vtkIdType):
 *   faces, edges and vertices of the mesh; pairs of a disc around triangles and tiles of the grid
 *   that culling tested; pairs of a site and a tile that it tested; pairs that it left; polygons
 *   drawn, 0 with the processor; grid points that they cover before the depth test, or pairs of a
 *   grid point and a site that the processor evaluated; grid points computed.
 * - Seconds (double, one named component a phase): wall-clock time of building sites (Sites),
 *   of finding out what is inside by winding numbers (Sign),
 *   culling (Cull), clipping polygons (Polygons), drawing or evaluating (Draw), final distances
 *   and read-back (Resolve), and the medial axis (Medial, 0 for vtkMeshDistanceField).
 * - Renderer and RendererVersion (strings: GL_RENDERER, GL_VERSION) and SoftwareRenderer (unsigned
 *   char, 0 or 1): the OpenGL implementation; missing if OpenGL was not used.
 *
 * The field data of the input is passed on, as by other filters of VTK.
 *
 * @par Errors:
 * A parameter outside its range, input that cannot be used, and a failure of the GPU are reported
 * by one vtkErrorMacro with the value and the allowed range; GetErrorCode() is then one of
 * ErrorCodes, all outputs are empty and the request fails (from VTK 9.2 on it succeeds, with
 * outputs that are marked as aborted, so that no other message follows). No filter downstream runs.
 * Observers of ErrorEvent are told even while vtkObject::GlobalWarningDisplay is off.
 * Parameters are checked when the filter executes; no value is clamped. Images larger than the
 * available memory are refused before anything is computed.
 *
 * @par Warnings:
 * If a device fails and ENGINE_AUTO leaves its work to the processor, a vtkWarningMacro says why,
 * once per process for each cause.
 *
 * @par Abort:
 * SetAbortExecute(1) from a ProgressEvent observer stops the execution soon: within a fraction of a
 * second, or within seconds if the mesh has a million triangles. The outputs are then empty, as
 * after an error, GetErrorCode() is CancelledError without an ErrorEvent from the filter, and the
 * next Update() executes again.
 *
 * @par OpenGL:
 * Only ENGINE_DEVICE, ENGINE_RASTERISER and RequireHardware need OpenGL. They use a thread and a
 * context of their own: an OpenGL context that is current in the calling thread stays current, with
 * its state. Observers are called in the calling thread.
 *
 * @par Parallel pipelines:
 * Whatever piece is requested, the filter asks for its whole input, since every grid point depends
 * on all of it.
 */

#ifndef vtkMeshFieldAlgorithm_h
#define vtkMeshFieldAlgorithm_h

#include "vtkAlgorithm.h"
#include "vtkErrorCode.h"           // For UserError
#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters

#include <memory> // For std::unique_ptr
#include <string> // For Device

class vtkDataObject;
class vtkPolyData;

class VTKMEDIALFILTERS_EXPORT vtkMeshFieldAlgorithm : public vtkAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for obtaining type information, and printing.
   */
  vtkTypeMacro(vtkMeshFieldAlgorithm, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Assigns a data object as input. This makes no pipeline connection: use SetInputConnection() for
   * the output of a filter.
   */
  void SetInputData(vtkDataObject* input);

  /**
   * Values of GetErrorCode() after a failed execution.
   */
  enum ErrorCodes
  {
    /// A parameter, the input or their combination is outside what is documented.
    InvalidInputError = vtkErrorCode::UserError + 1,
    /// No usable OpenGL 4.5 context, or a software one where hardware is required.
    NoGpuError,
    /// The driver refused a shader.
    ShaderBuildError,
    /// The request exceeds a limit of the GPU or its driver.
    GpuLimitError,
    /// Host or device memory ran out.
    OutOfMemoryError,
    /// AbortExecute was set during the execution.
    CancelledError,
    /// Any other failure.
    InternalError
  };

  /**
   * How the grid is chosen.
   */
  enum GridModes
  {
    RESOLUTION = 0,
    SPACING = 1,
    EXPLICIT = 2
  };

  /**
   * What finds the closest sites.
   */
  enum Engines
  {
    ENGINE_AUTO = 0,
    ENGINE_RASTERISER = 1,
    ENGINE_PROCESSOR = 2,
    ENGINE_DEVICE = 3
  };

  ///@{
  /**
   * How the grid is chosen. RESOLUTION: cubic voxels, with Resolution points along the longest
   * axis. SPACING: voxels of the size Spacing. Both cover the bounds of the input with a margin of
   * Padding on every side. EXPLICIT: Origin, Spacing and Dimensions as they are, whatever the
   * input. Default is RESOLUTION.
   */
  vtkSetMacro(GridMode, int);
  vtkGetMacro(GridMode, int);
  void SetGridModeToResolution() { this->SetGridMode(RESOLUTION); }
  void SetGridModeToSpacing() { this->SetGridMode(SPACING); }
  void SetGridModeToExplicit() { this->SetGridMode(EXPLICIT); }
  const char* GetGridModeAsString();
  ///@}

  ///@{
  /**
   * Number of grid points along the longest axis of the padded bounds, in [2, 8192]. Time and
   * memory grow with its cube. Used when GridMode is RESOLUTION. Default is 256.
   */
  vtkSetMacro(Resolution, int);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Distance between neighbouring grid points along x, y and z in world units, each > 0; they may
   * differ. Used when GridMode is SPACING, where it must give at most 8192 points along an axis, or
   * EXPLICIT. Default is (1, 1, 1).
   */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /**
   * World coordinates of the first grid point, any finite numbers. Used when GridMode is EXPLICIT.
   * Default is (0, 0, 0).
   */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /**
   * Number of grid points along x, y and z, each in [1, 8192]. Used when GridMode is EXPLICIT.
   * Default is (64, 64, 64).
   */
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  ///@}

  ///@{
  /**
   * Margin around the bounds of the input as a fraction of their diagonal, in [0, 10]. Used when
   * GridMode is RESOLUTION or SPACING. Larger values show more of the outside; with RESOLUTION
   * they also make voxels larger. Default is 0.05.
   */
  vtkSetMacro(Padding, double);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /**
   * How inside, where the distance is negative, is told from outside; the magnitude of the distance
   * does not depend on it. SIGN_WINDING: generalised winding numbers, for any mesh of triangles,
   * also with holes, and with parts that overlap, touch or face different ways. SIGN_AUTO:
   * SIGN_WINDING, but SIGN_NONE if the mesh does not define an inside. That is the case if it has
   * no triangles, or if its winding number is between 1/4 and 3/4 at more than 1 % of the grid and
   * its holes are more than an eighth of the closed surface. SIGN_NONE: unsigned.
   * SIGN_PSEUDONORMAL: angle-weighted pseudonormals, wrong where parts overlap or touch; an error
   * where the mesh is open or not consistently oriented. Default is SIGN_AUTO. The field data array
   * SignMethod says what was chosen.
   */
  vtkMedialSignMethodMacro();
  ///@}

  ///@{
  /**
   * What finds the closest sites: the result does not depend on it, but the time does.
   * ENGINE_RASTERISER: OpenGL draws bounds of Voronoi regions with the depth test.
   * ENGINE_PROCESSOR: the CPU evaluates the candidates of every tile of the grid, without OpenGL.
   * ENGINE_DEVICE: compute shaders of OpenGL do the same. ENGINE_AUTO: ENGINE_DEVICE if there is
   * graphics hardware that works, ENGINE_PROCESSOR otherwise. Default is ENGINE_AUTO. The field
   * data array Engine says what was chosen.
   */
  vtkSetMacro(Engine, int);
  vtkGetMacro(Engine, int);
  void SetEngineToAuto() { this->SetEngine(ENGINE_AUTO); }
  void SetEngineToRasteriser() { this->SetEngine(ENGINE_RASTERISER); }
  void SetEngineToProcessor() { this->SetEngine(ENGINE_PROCESSOR); }
  void SetEngineToDevice() { this->SetEngine(ENGINE_DEVICE); }
  const char* GetEngineAsString();
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
   * Upper bound in MiB on the memory for the slabs of slices that are computed at a time, 0 or
   * >= 64; 0 chooses by the size of the grid. Outputs are not counted. Smaller values make more
   * slabs and take longer; the result does not depend on it. Default is 0.
   */
  vtkSetMacro(MemoryLimit, int);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  ///@{
  /**
   * What an engine that uses OpenGL computes on: a device's number, or a part of its name, as
   * medial-axis --list-devices prints them; empty for the first GPU, else a software renderer.
   * If there is no such device, or it fails, ENGINE_AUTO leaves the work to the processor, with a
   * warning. A process has one device, that of its first such engine. Default is empty.
   */
  virtual void SetDevice(const char* device);
  vtkGetCharFromStdStringMacro(Device);
  ///@}

  ///@{
  /**
   * Whether to fail if there is no OpenGL, or only a software renderer such as Mesa's llvmpipe,
   * whatever the engine. Default is off: a software renderer gives the same result, but slowly.
   */
  vtkSetMacro(RequireHardware, vtkTypeBool);
  vtkGetMacro(RequireHardware, vtkTypeBool);
  vtkBooleanMacro(RequireHardware, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the image has the point data array ClosestPoint: the world coordinates of the closest
   * point of the mesh, float32 x 3. Costs 12 bytes per grid point. Default is on.
   */
  vtkSetMacro(GenerateClosestPoint, vtkTypeBool);
  vtkGetMacro(GenerateClosestPoint, vtkTypeBool);
  vtkBooleanMacro(GenerateClosestPoint, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the image has the point data array ClosestCell: the id of an input cell that holds the
   * closest point, vtkIdType. Costs 8 bytes per grid point. Default is on.
   */
  vtkSetMacro(GenerateClosestCell, vtkTypeBool);
  vtkGetMacro(GenerateClosestCell, vtkTypeBool);
  vtkBooleanMacro(GenerateClosestCell, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the image has the point data array ClosestFeature: what the closest point lies on, 0
   * for a vertex, 1 for an edge, 2 for a face, uint8. Costs 1 byte per grid point. Default is on.
   */
  vtkSetMacro(GenerateClosestFeature, vtkTypeBool);
  vtkGetMacro(GenerateClosestFeature, vtkTypeBool);
  vtkBooleanMacro(GenerateClosestFeature, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether the image has the point data array ClosestSite: the label of the closest vertex, edge
   * or face of the welded mesh, that is the generalised Voronoi diagram, int32. Faces come first,
   * then edges, then vertices. Costs 4 bytes per grid point. Default is on.
   */
  vtkSetMacro(GenerateClosestSite, vtkTypeBool);
  vtkGetMacro(GenerateClosestSite, vtkTypeBool);
  vtkBooleanMacro(GenerateClosestSite, vtkTypeBool);
  ///@}

  /**
   * see vtkAlgorithm for details
   */
  vtkTypeBool ProcessRequest(vtkInformation*, vtkInformationVector**,
    vtkInformationVector*) override;

protected:
  vtkMeshFieldAlgorithm();
  ~vtkMeshFieldAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  virtual int RequestInformation(vtkInformation*, vtkInformationVector**,
    vtkInformationVector*) = 0;
  virtual int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*);
  virtual int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) = 0;

  /**
   * Describes an image output on the grid that the parameters and the input ask for. Updates the
   * input where the grid depends on it. Composite input has no grid: the pipeline asks again for
   * each of its blocks. Returns 0 after reporting an error.
   */
  int RequestImageInformation(vtkInformationVector** inputVector,
    vtkInformationVector* outputVector, int port);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  int GridMode = RESOLUTION;
  int Resolution = 256;
  double Spacing[3] = { 1.0, 1.0, 1.0 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  int Dimensions[3] = { 64, 64, 64 };
  double Padding = 0.05;
  int SignMethod = SIGN_AUTO;
  int Engine = ENGINE_AUTO;
  int NumberOfThreads = 0;
  int MemoryLimit = 0;
  std::string Device;
  vtkTypeBool RequireHardware = false;
  vtkTypeBool GenerateClosestPoint = true;
  vtkTypeBool GenerateClosestCell = true;
  vtkTypeBool GenerateClosestFeature = true;
  vtkTypeBool GenerateClosestSite = true;

private:
  vtkPolyData* UpdateWholeInput(vtkInformationVector** inputVector);
  int RefuseData(vtkInformationVector* outputVector);

  vtkMeshFieldAlgorithm(const vtkMeshFieldAlgorithm&) = delete;
  void operator=(const vtkMeshFieldAlgorithm&) = delete;
};

#endif
