/**
 * What vtkMeshFieldAlgorithm keeps from its users: the library's view of the input and of the
 * parameters, and the figures of the last execution. Private to the module.
 */

#ifndef vtkMeshFieldInternals_h
#define vtkMeshFieldInternals_h

#include "vtkMeshConversion.h"
#include "vtkMeshFieldAlgorithm.h"
#include "vtkType.h" // For vtkMTimeType

#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/execution.h"

#include <functional>
#include <string>

class vtkMeshFieldAlgorithm::vtkInternals
{
public:
  explicit vtkInternals(vtkMeshFieldAlgorithm* self)
    : Self(self)
  {
  }

  /**
   * What is known after an execution.
   */
  struct Outcome
  {
    medial::Grid Grid{ {}, {}, {} };
    medial::SignMethod Sign = medial::SignMethod::Auto;
    medial::Side Side = medial::Side::Both;
    medial::RunStatistics Statistics;
    vtkIdType NumberOfTriangles = 0;
    vtkIdType NumberOfVertices = 0;
    vtkIdType NumberOfComponents = 0;
    vtkIdType NumberOfDegenerateTriangles = 0;
    bool Closed = false;
    bool Manifold = false;
    bool Oriented = false;
  };

  /**
   * Runs work as vtkRunGuarded(), and forgets the last execution where it fails.
   */
  bool Try(const std::function<void()>& work);

  /**
   * Forgets the last execution, and what vtkImageData keeps of it for reuse.
   */
  void Begin(vtkInformationVector* outputVector);

  /**
   * Makes Mesh and Connectivity those of input, unless they are already.
   */
  void UpdateMesh(vtkPolyData* input);

  /**
   * The grid that the parameters ask for. input may be null for an explicit grid.
   */
  medial::Grid MakeGrid(vtkPolyData* input);

  /**
   * The grid that RequestImageInformation() announced, whatever the input has become since.
   */
  static medial::Grid AnnouncedGrid(vtkInformation* outInfo);

  /**
   * The parameters of the distance field, checked as far as the library cannot.
   */
  medial::DistanceFieldOptions MakeOptions(medial::Progress* progress);

  /**
   * The image arrays that the Generate flags ask for.
   */
  vtkMeshConversion::ArraySelection MakeSelection();

  /**
   * Fills Last after an execution on the current mesh.
   */
  void Record(const medial::Grid& grid, medial::SignMethod sign,
    const medial::RunStatistics& statistics);

  bool InputIsBlock = false; // of composite input that the pipeline goes through
  medial::TriangleMesh Mesh;
  medial::MeshConnectivity Connectivity;
  Outcome Last;

private:
  vtkMeshFieldAlgorithm* Self;
  vtkPolyData* MeshInput = nullptr; // only ever compared
  vtkMTimeType MeshTime = 0;
};

/**
 * Runs work and turns what it throws into VTK's error reporting: errorCode, the algorithm's own,
 * becomes one of vtkMeshFieldAlgorithm::ErrorCodes, with an ErrorEvent unless an observer stopped
 * the work. Returns whether all went well.
 */
bool vtkRunGuarded(vtkAlgorithm* algorithm, unsigned long& errorCode,
  const std::function<void()>& work);

/**
 * Ends an execution that failed or was stopped: the outputs are empty, and made again on the next
 * update. Returns what RequestData() is to return.
 */
int vtkEndWithoutOutput(vtkAlgorithm* algorithm, vtkInformationVector* outputVector);

/**
 * Throws a medial::Error that says that a parameter is not what range says.
 */
[[noreturn]] void vtkThrowBadParameter(const char* name, int value, const char* range);

/**
 * A value of the SideType of a filter as the library's side. Throws where it is none.
 */
template <typename FilterType>
medial::Side vtkToSide(int side)
{
  switch (side)
  {
    case FilterType::INTERIOR:
      return medial::Side::Interior;
    case FilterType::EXTERIOR:
      return medial::Side::Exterior;
    case FilterType::BOTH:
      return medial::Side::Both;
    default:
      vtkThrowBadParameter("Side", side, "one of 0 (interior), 1 (exterior), 2 (both)");
  }
}

/**
 * The same as a word.
 */
template <typename FilterType>
const char* vtkSideAsString(int side)
{
  switch (side)
  {
    case FilterType::INTERIOR:
      return "Interior";
    case FilterType::EXTERIOR:
      return "Exterior";
    case FilterType::BOTH:
      return "Both";
    default:
      return "Unknown";
  }
}

/**
 * Asks for the whole input instead of a piece.
 */
void vtkRequestWhole(vtkInformation* request);

/**
 * Passes the library's progress on to a VTK algorithm's observers, and their wish to stop back.
 */
class vtkProgressBridge : public medial::Progress
{
public:
  /**
   * For use from here on: a wish to stop an earlier execution is forgotten.
   */
  explicit vtkProgressBridge(vtkAlgorithm* algorithm);

  void report(double fraction, const char* phase) override;
  bool cancelled() override;

private:
  vtkAlgorithm* Algorithm;
};

#endif
