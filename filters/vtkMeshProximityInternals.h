/**
 * The private part of vtkMeshProximity: the meshes as the library takes them, and what is kept from
 * frame to frame. Private to the module.
 */

#ifndef vtkMeshProximityInternals_h
#define vtkMeshProximityInternals_h

#include "vtkMeshProximity.h"
#include "vtkType.h" // For vtkMTimeType

#include "medial/proximity.h"

#include <optional>

class vtkMeshProximity::vtkInternals
{
public:
  /**
   * Makes the mesh of a port that of input, moved by transform (may be null), and moved the same as
   * a vtkPolyData. Throws medial::Error InvalidInput, naming A or B.
   */
  void Move(int port, vtkPolyData* input, vtkLinearTransform* transform, vtkPolyData* moved);

  /**
   * Computes on the moved meshes. Valid until the next call.
   */
  const medial::Proximity& Compute(const medial::ProximityOptions& options);

  const medial::TriangleMesh& GetMesh(int port) const { return this->Bodies[port].Mesh; }

private:
  struct Body
  {
    void Update(vtkPolyData* input);
    void MovePoints(vtkPolyData* moved);

    vtkPolyData* Input = nullptr; // only ever compared
    vtkMTimeType InputTime = 0;
    medial::TriangleMesh Mesh;
    bool IsNew = false;   // the solver has other cells
    bool IsMoved = false; // the solver has other positions
  };

  std::array<Body, 2> Bodies;
  std::optional<medial::ProximitySolver> Solver;
};

#endif
