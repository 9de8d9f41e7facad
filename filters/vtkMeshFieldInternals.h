/**
 * The private part of vtkMeshFieldAlgorithm: the input and the parameters as the library takes
 * them. Private to the module.
 */

#ifndef vtkMeshFieldInternals_h
#define vtkMeshFieldInternals_h

#include "vtkMeshConversion.h"
#include "vtkMeshFieldAlgorithm.h"
#include "vtkType.h" // For vtkMTimeType

#include "medial/compute_medial_axis.h"
#include "medial/execution.h"

#include <exception>
#include <functional>
#include <optional>
#include <string>

class vtkMeshFieldAlgorithm::vtkInternals
{
public:
  explicit vtkInternals(vtkMeshFieldAlgorithm* self)
    : Self(self)
  {
  }

  /**
   * Runs work as vtkRunGuarded().
   */
  bool Try(const std::function<void()>& work);

  /**
   * Forgets what vtkImageData keeps of the last execution for reuse.
   */
  static void Begin(vtkInformationVector* outputVector);

  /**
   * Makes Mesh and Connectivity those of input, unless they are already. The execution can cancel
   * that.
   */
  void UpdateMesh(vtkPolyData* input, const medial::Execution& execution = {});

  /**
   * The grid that the parameters ask for. input may be null for an explicit grid.
   */
  medial::Grid MakeGrid(vtkPolyData* input);

  /**
   * The same for a surface with these bounds, which do not matter for an explicit grid.
   */
  medial::Grid MakeGrid(const medial::Bounds& bounds);

  /**
   * Describes an image output on a grid. makeGrid may throw, or return nothing where there is no
   * grid yet. Returns 0 after reporting an error.
   */
  int AnnounceImage(vtkInformationVector* outputVector, int port,
    const std::function<std::optional<medial::Grid>()>& makeGrid);

  /**
   * What is announced in place of a grid that is refused: a point, as VTK's filters downstream read
   * the extent without a check.
   */
  static medial::Grid UnitGrid();

  /**
   * The grid that RequestImageInformation() announced, whatever the input has become since.
   */
  static medial::Grid AnnouncedGrid(vtkInformation* outInfo);

  /**
   * The parameters of the distance field. Checks what the library cannot check.
   */
  medial::DistanceFieldOptions MakeOptions(medial::Progress& progress);

  /**
   * The parameters that must be the same on all ranks, a line with a name and values each.
   */
  std::string DescribeOptions();

  /**
   * The image arrays that the Generate flags ask for.
   */
  vtkMeshConversion::ArraySelection MakeSelection();

  /**
   * Adds the field data arrays of the filter's manual to an output; those of the mesh only if it is
   * that of the execution.
   */
  void Record(const medial::Grid& grid, const medial::RunStatistics& statistics,
    vtkDataObject* output, bool withMesh = true);

  bool InputIsBlock = false;  // of composite input that the pipeline goes through
  std::exception_ptr Refusal; // why RequestImageInformation() failed last; null if it did not
  medial::TriangleMesh Mesh;
  medial::MeshConnectivity Connectivity;

private:
  vtkMeshFieldAlgorithm* Self;
  vtkPolyData* MeshInput = nullptr; // only ever compared
  vtkMTimeType MeshTime = 0;
};

#endif
