#include "field/field_sign.h"

namespace medial
{

FieldSign fieldSign(SignMethod method, const MeshConnectivity& connectivity)
{
  switch (method)
  {
    case SignMethod::Winding:
      return FieldSign::Rows;
    case SignMethod::Pseudonormal:
      return connectivity.signedVolume < 0.0 ? FieldSign::Inward : FieldSign::Outward;
    case SignMethod::Auto:
    case SignMethod::None:
      break;
  }
  return FieldSign::None;
}

} // namespace medial
