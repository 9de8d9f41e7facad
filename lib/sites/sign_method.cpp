#include "medial/sign_method.h"

#include "medial/error.h"
#include "medial/mesh_connectivity.h"

#include <string>

namespace medial
{

SignMethod resolveSignMethod(SignMethod requested, const MeshConnectivity& connectivity)
{
  const bool possible = connectivity.closed() && connectivity.oriented();
  switch (requested)
  {
    case SignMethod::Auto:
      return possible ? SignMethod::Pseudonormal : SignMethod::None;
    case SignMethod::Pseudonormal:
      if (!possible)
      {
        throw Error(ErrorCode::InvalidInput,
          "sign method pseudonormal needs a closed, consistently oriented mesh; this one has " +
            std::to_string(connectivity.boundaryEdges) + " boundary, " +
            std::to_string(connectivity.nonManifoldEdges) + " non-manifold and " +
            std::to_string(connectivity.misorientedEdges) + " misoriented edges; use auto or none");
      }
      return requested;
    case SignMethod::None:
      break;
  }
  return SignMethod::None;
}

} // namespace medial
