#pragma once

#include "medial/mesh_connectivity.h"
#include "medial/sign_method.h"

namespace medial
{

/// Sign of the field: none, from the pseudonormals of a surface that faces outwards or inwards, or
/// from the rows of grid points that are inside.
enum class FieldSign
{
  None,
  Outward,
  Inward,
  Rows
};

/// Whether pseudonormals give the sign.
inline bool hasPseudonormals(FieldSign sign)
{
  return sign == FieldSign::Outward || sign == FieldSign::Inward;
}

/// Returns the sign of the field of a mesh.
/// @param method never Auto.
FieldSign fieldSign(SignMethod method, const MeshConnectivity& connectivity);

} // namespace medial
