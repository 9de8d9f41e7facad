#include "field/field_sign.h"

namespace medial
{

FieldSign fieldSign(SignMethod method, const MeshConnectivity& connectivity)
{
  if (method != SignMethod::Pseudonormal)
  {
    return FieldSign::None;
  }
  return connectivity.signedVolume < 0.0 ? FieldSign::Inward : FieldSign::Outward;
}

} // namespace medial
