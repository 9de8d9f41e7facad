#pragma once

#include "medial/export.h"

namespace medial
{

struct MeshConnectivity;

/// How to tell inside from outside. Negative is inside; the magnitude never depends on the method.
/// Pseudonormals are weighted by angles (Baerentzen, Aanaes, 2005).
enum class SignMethod
{
  Auto,        ///< Pseudonormal for closed, consistently oriented meshes, otherwise None
  None,        ///< unsigned distance
  Pseudonormal ///< angle-weighted pseudonormals; the mesh must be closed and oriented
};

/// Returns the method that `requested` means for a mesh, never Auto.
/// @throws Error InvalidInput for Pseudonormal if the mesh is open or not consistently oriented.
MEDIAL_EXPORT SignMethod resolveSignMethod(SignMethod requested,
  const MeshConnectivity& connectivity);

} // namespace medial
