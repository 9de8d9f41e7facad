/**
 * @class   vtkMeshProximity
 * @brief proximity of two meshes, which may move and deform: separation, collision, depth, contacts
 *
 * vtkMeshProximity computes for the mesh of input port 0, A, and that of input port 1, B, how far
 * they are apart and where, whether they intersect or collide, how deep one is inside the other,
 * where they are in contact, and how far one must move to be clear of the other. All of it is
 * computed on the meshes themselves, in double precision, without a grid or OpenGL. The meshes need
 * no preparation.
 *
 * @par Input:
 * Any two vtkPolyData, as for vtkMedialAxis: polygons, triangle strips, lines and vertices, closed
 * or not. The solid of a closed mesh is where its winding number is 1 or more, of an open mesh
 * where its generalised winding number is above 3/4; lines and vertices have no solid.
 *
 * @par Output port 0:
 * The witnesses and the contacts, points in double precision. Where the meshes are apart a line
 * joins the closest point of A with that of B, unless Separation is off or they are beyond
 * MaximumSeparation; where they intersect a vertex is a common point.
 * Each contact is a vertex. Point data arrays: Kind (unsigned char, the active scalars: 0 for a
 * witness, 1 for a contact); Normal (float64 x 3, the active vectors, the unit vector from A to B:
 * moving B along it separates them there; 0 at a common point); Depth (float64, how deep a contact
 * is, in world units, >= 0; 0 for a witness); Manifold (int, contacts of one connected overlap
 * share a number, from 0; -1 for a witness); BodyA and BodyB (int, the input ports of A and of B, 0
 * and 1); CellA and CellB (vtkIdType, the cells of the inputs; both points of a line have both).
 *
 * @par Output ports 1 and 2:
 * A and B where their transforms have moved them, with points in double precision where they moved.
 * If Depths is on they have the point data array PenetrationDepth (float64, world units, the active
 * scalars): the distance of points inside the other mesh to its surface, 0 for points outside. It
 * is NaN where inside is undefined, and at points of no cell.
 *
 * @par Field data:
 * Output port 0 has field data arrays of one tuple. Separation (double) is the smallest distance
 * between the surfaces in world units, 0 if and only if they intersect, infinite beyond
 * MaximumSeparation and NaN if it was not asked for. Three arrays are unsigned char, 0 or 1:
 * Intersect, whether the surfaces intersect, which is exact; Collide, whether they intersect or one
 * solid contains a part of the other mesh; and InsideUndefined, whether an open mesh does not
 * define its inside. With Depths there are PenetrationDepth (double), the largest distance of a
 * surface point of one mesh inside the other to the other's surface, 0 if they do not collide and
 * NaN if inside is undefined; PenetrationDepthAtMost (double), which no such distance exceeds; and
 * DeepestPoint (double x 3), where the largest is, NaN if there is no such point. With
 * TranslationalDepth there are TranslationalDepth (double x 2), a lower and an upper bound on the
 * length of the shortest translation that separates the solids, and SeparatingTranslation (double
 * x 3), which separates them if A moves by it. Without Depths, and where inside is undefined, the
 * translation of meshes that collide is unknown: the upper bound is infinite and
 * SeparatingTranslation NaN. Seconds (double) is the wall-clock time that it took, without
 * conversions.
 *
 * @par Frames:
 * While the cells and the number of points of both inputs stay the same, as in a time series, and
 * while only transforms change, the filter keeps what it has built and only moves points. What is
 * inside follows from the points of each execution, also where transforms or points mirror a mesh
 * or parts of it. Results depend on earlier executions only in their last bits, except for the
 * bounds of the translational depth, which may be wider or narrower.
 *
 * @par Errors:
 * An input without cells, a coordinate that is not finite, before or after a transform, a transform
 * whose determinant is 0 or not finite, and parameters outside their ranges. Messages call the
 * meshes A and B. vtkMedialPolyDataAlgorithm documents how errors are reported, abort and parallel
 * pipelines.
 *
 * @sa
 * vtkMeshDistanceField vtkMedialThickness vtkMedialPolyDataAlgorithm
 */

#ifndef vtkMeshProximity_h
#define vtkMeshProximity_h

#include "vtkMedialFiltersModule.h" // For export macro
#include "vtkMedialParameters.h"    // For parameters of several filters
#include "vtkMedialPolyDataAlgorithm.h"

#include <memory> // For the internals

class vtkLinearTransform;

class VTKMEDIALFILTERS_EXPORT vtkMeshProximity : public vtkMedialPolyDataAlgorithm
{
public:
  ///@{
  /**
   * Standard methods for instantiation, obtaining type information, and printing.
   */
  static vtkMeshProximity* New();
  vtkTypeMacro(vtkMeshProximity, vtkMedialPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * What moves A before anything is computed: translation, rotation, scale, also by a matrix
   * (vtkTransform). Its determinant must be finite and not 0. Default is nullptr: A stays where it
   * is.
   */
  virtual void SetTransformA(vtkLinearTransform* transform);
  vtkGetObjectMacro(TransformA, vtkLinearTransform);
  ///@}

  ///@{
  /**
   * What moves B before anything is computed: translation, rotation, scale, also by a matrix
   * (vtkTransform). Its determinant must be finite and not 0. Default is nullptr: B stays where it
   * is.
   */
  virtual void SetTransformB(vtkLinearTransform* transform);
  vtkGetObjectMacro(TransformB, vtkLinearTransform);
  ///@}

  ///@{
  /**
   * Whether to compute the smallest distance between meshes that do not intersect, and the
   * witnesses. Without it, their Separation is NaN. Intersect and Collide are always computed.
   * Default is on.
   */
  vtkSetMacro(Separation, vtkTypeBool);
  vtkGetMacro(Separation, vtkTypeBool);
  vtkBooleanMacro(Separation, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Meshes whose bounding boxes are farther apart than this are not compared: the figure Separation
   * is infinite, they do not collide, and there are no witnesses. World units, >= 0.
   * Default is 1e+299: all are compared.
   */
  vtkSetMacro(MaximumSeparation, double);
  vtkGetMacro(MaximumSeparation, double);
  ///@}

  ///@{
  /**
   * Whether to compute how deep the meshes are inside each other: PenetrationDepth, and what needs
   * it, the contacts and TranslationalDepth. Default is on.
   */
  vtkSetMacro(Depths, vtkTypeBool);
  vtkGetMacro(Depths, vtkTypeBool);
  vtkBooleanMacro(Depths, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Whether to bound the length of the shortest translation that separates the solids. Needs
   * Depths. Default is on.
   */
  vtkSetMacro(TranslationalDepth, vtkTypeBool);
  vtkGetMacro(TranslationalDepth, vtkTypeBool);
  vtkBooleanMacro(TranslationalDepth, vtkTypeBool);
  ///@}

  ///@{
  /**
   * Largest number of contacts of a manifold, which is one connected overlap of the meshes, >= 1,
   * or 0 to compute no contacts. Contacts need Depths. Default is 4.
   */
  vtkSetMacro(MaximumNumberOfContacts, int);
  vtkGetMacro(MaximumNumberOfContacts, int);
  ///@}

  ///@{
  /**
   * How far PenetrationDepth may be below the true maximum, as a fraction of it, in the open
   * interval (0, 1). Larger values take less time. Differences below 1e-5 of the diagonal of the
   * smaller mesh are not resolved. Default is 0.001.
   */
  vtkSetMacro(DepthTolerance, double);
  vtkGetMacro(DepthTolerance, double);
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
   * A and B as they are compared: output ports 1 and 2.
   */
  vtkPolyData* GetMovedA();
  vtkPolyData* GetMovedB();
  ///@}

  /**
   * Changes of the transforms count as changes of the filter.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkMeshProximity();
  ~vtkMeshProximity() override;

  void Execute(const std::vector<vtkPolyData*>& inputs,
    const std::vector<vtkPolyData*>& outputs) override;

  vtkLinearTransform* TransformA = nullptr;
  vtkLinearTransform* TransformB = nullptr;
  vtkTypeBool Separation = true;
  double MaximumSeparation = VTK_DOUBLE_MAX;
  vtkTypeBool Depths = true;
  vtkTypeBool TranslationalDepth = true;
  int MaximumNumberOfContacts = 4;
  double DepthTolerance = 1e-3;
  int NumberOfThreads = 0;

private:
  vtkMeshProximity(const vtkMeshProximity&) = delete;
  void operator=(const vtkMeshProximity&) = delete;

  class vtkInternals;
  const std::unique_ptr<vtkInternals> Internals;
};

#endif
