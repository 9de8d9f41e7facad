#pragma once

#include <cstdint>
#include <string>

namespace medial
{

/// How to tell inside from outside. Negative is inside; the magnitude never depends on the method.
enum class SignMethod
{
  /// Winding, or None if the mesh does not define an inside: if it has no triangles; if its winding
  /// number is between 1/4 and 3/4 at more than 1 % of the grid points, and lids of its holes would
  /// be more than an eighth of the surface that they close; or if its holes have more than 1,000
  /// edges and more than half as many as there are triangles.
  Auto,
  /// Unsigned distance.
  None,
  /// Angle-weighted pseudonormals (Baerentzen, Aanaes 2005). The mesh must be closed and
  /// consistently oriented. Wrong where parts overlap, touch or face different ways.
  Pseudonormal,
  /// Generalised winding numbers (Jacobson, Kavan, Sorkine-Hornung 2013) above 1/2 are inside, also
  /// for meshes with holes, with parts that overlap, touch or face different ways, and with
  /// duplicate triangles. The mesh must have triangles.
  Winding
};

/// How the sign of a field was found.
struct SignReport
{
  SignMethod method = SignMethod::None; ///< the method used, never Auto
  std::string reason;                   ///< why this method, in words
  std::int64_t rimEdges = 0;            ///< Winding: edges of holes, under imaginary lids
  std::int64_t holes = 0;               ///< Winding: connected pieces of these edges
  std::int64_t copies = 0;              ///< Winding: triangles left out as copies of others
  std::int64_t turned = 0;              ///< Winding: triangles turned round
  double ambiguousShare = 0.0; ///< Auto, Winding: share of the grid with winding number 1/4 to 3/4
  double lidShare = 0.0; ///< Auto, Winding: area of the holes' lids over that of all, lids included
};

} // namespace medial
