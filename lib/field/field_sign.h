#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"

namespace medial
{

/// Sign of the field: none, or from the pseudonormals of a surface that faces outwards or inwards.
enum class FieldSign
{
  None,
  Outward,
  Inward
};

/// Returns the sign of the field of a mesh.
/// @param method never Auto; see resolveSignMethod().
FieldSign fieldSign(SignMethod method, const MeshConnectivity& connectivity);

} // namespace medial
