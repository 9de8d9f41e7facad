#include "medial/cell_topology.h"

#include "axis/face_complex.h"
#include "base/disjoint_sets.h"
#include "medial/medial_axis.h"

#include <vector>

namespace medial
{
namespace
{

/// Returns the rank of the second homology with coefficients modulo 2. Faces that end somewhere
/// bound nothing and are removed. The rest are patches of a manifold: a cycle has all of a patch or
/// nothing of it, and each seam of three or more adds a condition.
std::int64_t cavitiesOf(FaceComplex& complex)
{
  complex.collapse();
  DisjointSets patches = complex.patches();
  std::int64_t count = 0;
  for (std::int64_t face = 0; face < complex.faceCount(); ++face)
  {
    count += complex.isLeft(face) && patches.find(face) == face ? 1 : 0;
  }
  return count - rankOf(complex.seams(patches));
}

/// Marks the points that cells use.
std::vector<char> usedPoints(const MedialAxis& axis, const std::vector<FaceComplex::Edge>& edges)
{
  std::vector<char> used(axis.points.size(), 0);
  for (const FaceComplex::Edge& edge : edges)
  {
    used[edge[0]] = 1;
    used[edge[1]] = 1;
  }
  for (const std::int64_t vertex : axis.vertices)
  {
    used[vertex] = 1;
  }
  return used;
}

} // namespace

CellTopology topologyOf(const MedialAxis& axis)
{
  FaceComplex complex(axis);
  const std::vector<char> used = usedPoints(axis, complex.edges());
  DisjointSets pieces(axis.points.size());
  for (const FaceComplex::Edge& edge : complex.edges())
  {
    pieces.join(edge[0], edge[1]);
  }
  CellTopology topology;
  std::int64_t points = 0;
  for (std::size_t p = 0; p < used.size(); ++p)
  {
    const auto point = static_cast<std::int64_t>(p);
    points += used[p];
    topology.components += used[p] != 0 && pieces.find(point) == point ? 1 : 0;
  }
  topology.eulerCharacteristic =
    points - static_cast<std::int64_t>(complex.edges().size()) + complex.faceCount();
  topology.cavities = cavitiesOf(complex);
  topology.genus = topology.components + topology.cavities - topology.eulerCharacteristic;
  return topology;
}

} // namespace medial
