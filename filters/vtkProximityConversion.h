/**
 * Conversion of the library's proximity of two meshes to VTK's data sets. Not installed: private to
 * the module and to the project's programs.
 */

#ifndef vtkProximityConversion_h
#define vtkProximityConversion_h

#include "medial/proximity.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

class vtkPolyData;

namespace vtkProximityConversion
{

/**
 * Witnesses and contacts of pairs of meshes with the point data arrays that vtkMeshProximity
 * documents, as they are added.
 */
class PointSet
{
public:
  PointSet();

  /**
   * Adds a line from the closest point of A to that of B, or a vertex where the surfaces intersect.
   * Nothing where the closest points are not known.
   */
  void AddWitnesses(const medial::Proximity& pair);

  /** Adds a vertex for each contact. */
  void AddContacts(const medial::Proximity& pair);

  /** Makes them the content of an empty data set, which shares what is added later, too. */
  void ShareWith(vtkPolyData* output);

private:
  enum Kinds : unsigned char
  {
    WITNESS = 0,
    CONTACT = 1
  };

  vtkIdType Add(Kinds kind, const medial::Proximity& pair, const medial::ProximityContact& place);

  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Verts;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkUnsignedCharArray> Kind;
  vtkNew<vtkDoubleArray> Normal;
  vtkNew<vtkDoubleArray> Depth;
  vtkNew<vtkIntArray> Manifold;
  vtkNew<vtkIntArray> BodyA;
  vtkNew<vtkIntArray> BodyB;
  vtkNew<vtkIdTypeArray> CellA;
  vtkNew<vtkIdTypeArray> CellB;
};

/**
 * Adds the figures of the pair as field data; only those that the options asked for.
 */
void AddFigures(const medial::Proximity& proximity, const medial::ProximityOptions& options,
  vtkPolyData* output);

/**
 * Attaches the point data array PenetrationDepth to the surface that mesh was made from. depths are
 * those of the points of mesh that are inside the other.
 */
void AddDepths(const medial::Proximity& proximity, const std::vector<medial::PointDepth>& depths,
  const medial::TriangleMesh& mesh, vtkPolyData* surface);

} // namespace vtkProximityConversion

#endif
