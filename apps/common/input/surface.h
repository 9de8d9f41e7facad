#pragma once

#include "medial/triangle_mesh.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace medial::app
{

/// A mesh from a file, for the library and for VTK. It is kept in the form that its reader made,
/// and converted to the other form only on demand.
class Surface
{
public:
  Surface() = default;
  explicit Surface(MeshInput mesh);
  /// @param mesh with the arrays of its file; kept, not copied.
  explicit Surface(vtkSmartPointer<vtkPolyData> mesh);

  /// The mesh for the library.
  MeshInput toMeshInput() const;

  /// The mesh that buildTriangleMesh() makes of it.
  /// @throws Error InvalidInput.
  TriangleMesh toTriangleMesh() const;

  /// The mesh for VTK, with points in double precision unless VTK read it; made once.
  vtkPolyData* polyData();

private:
  MeshInput mesh_; // empty where VTK read it
  vtkSmartPointer<vtkPolyData> polyData_;
  bool readByVtk_ = false;
};

} // namespace medial::app
