#pragma once

#include "medial/export.h"

namespace medial
{

struct MeshConnectivity;

/// How inside is told from outside. Negative is inside; the magnitude never depends on the method.
enum class SignMethod
{
  Auto,        ///< Pseudonormal for closed, consistently oriented meshes, else None
  None,        ///< unsigned distance
  Pseudonormal ///< angle-weighted pseudonormals; the mesh must be closed and oriented
};

/// The sign method that `requested` means for a mesh.
/// @throws Error InvalidInput for Pseudonormal where the mesh is open or not consistently oriented.
MEDIAL_EXPORT SignMethod resolveSignMethod(SignMethod requested,
  const MeshConnectivity& connectivity);

} // namespace medial
