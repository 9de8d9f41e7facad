#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"

namespace medial
{

/// Sign of the field: none, or from the pseudonormals, possibly of a surface that faces inwards.
enum class FieldSign
{
  None,
  Outward,
  Inward
};

/// @param method resolved, not Auto.
FieldSign fieldSign(SignMethod method, const MeshConnectivity& connectivity);

} // namespace medial
