#include "medial/subdivision.h"

#include "base/checkpoint.h"
#include "medial/error.h"
#include "mesh/edge_list.h"

#include <glm/glm.hpp>

#include <cmath>
#include <new>
#include <sstream>

namespace medial
{
namespace
{

constexpr const char* kPhase = "subdivision";
constexpr std::size_t kMaxTriangles = 100000000;

glm::dvec3 positionOf(const TriangleMesh& mesh, int point)
{
  const Point3& x = mesh.points[point];
  return { x[0], x[1], x[2] };
}

/// Halves all edges that are longer than a limit once.
class Pass
{
public:
  Pass(Subdivision& result, double maxEdge, const Checkpoint& checkpoint)
    : mesh_(result.mesh)
    , parents_(result.parents)
    , maxEdge_(maxEdge)
    , checkpoint_(checkpoint)
  {
  }

  /// Returns whether there was a long edge.
  bool run()
  {
    this->addMiddles();
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::int64_t> cells;
    triangles.swap(mesh_.triangles);
    cells.swap(mesh_.triangleCells);
    bool changed = false;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      checkpoint_(i);
      changed = this->split(triangles[i], middles_[i]) || changed;
      mesh_.triangleCells.resize(mesh_.triangles.size(), cells[i]);
    }
    return changed;
  }

private:
  double lengthOf(int a, int b) const
  {
    return glm::distance(positionOf(mesh_, a), positionOf(mesh_, b));
  }

  /// Per triangle and edge, the point in its middle; -1 for short edges.
  void addMiddles()
  {
    const EdgeList edges(mesh_, checkpoint_);
    std::vector<int> middleOf(edges.size(), -1);
    middles_.resize(mesh_.triangles.size());
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i)
    {
      checkpoint_(i);
      const std::array<int, 3> corners = mesh_.triangles[i];
      for (int side = 0; side < 3; ++side)
      {
        int& middle = middleOf[edges.ofTriangle(i)[side]];
        const int a = corners[side];
        const int b = corners[(side + 1) % 3];
        if (middle < 0 && this->lengthOf(a, b) > maxEdge_)
        {
          middle = static_cast<int>(mesh_.points.size());
          const glm::dvec3 x = 0.5 * (positionOf(mesh_, a) + positionOf(mesh_, b));
          mesh_.points.push_back({ x.x, x.y, x.z });
          parents_.push_back({ a, b });
        }
        middles_[i][side] = middle;
      }
    }
  }

  void add(int a, int b, int c) { mesh_.triangles.push_back({ a, b, c }); }

  bool split(const std::array<int, 3>& corners, const std::array<int, 3>& middles)
  {
    int first = 0; // a long edge after a short one, if both are there
    int count = 0;
    for (int side = 0; side < 3; ++side)
    {
      count += middles[side] >= 0 ? 1 : 0;
      first = middles[side] >= 0 && middles[(side + 2) % 3] < 0 ? side : first;
    }
    const int a = corners[first];
    const int b = corners[(first + 1) % 3];
    const int c = corners[(first + 2) % 3];
    const int ab = middles[first];
    const int bc = middles[(first + 1) % 3];
    const int ca = middles[(first + 2) % 3];
    switch (count)
    {
      case 0:
        this->add(a, b, c);
        break;
      case 1:
        this->add(a, ab, c);
        this->add(ab, b, c);
        break;
      case 2:
        this->add(ab, b, bc);
        // The shorter diagonal of what is left.
        if (this->lengthOf(a, bc) <= this->lengthOf(ab, c))
        {
          this->add(a, ab, bc);
          this->add(a, bc, c);
        }
        else
        {
          this->add(a, ab, c);
          this->add(ab, bc, c);
        }
        break;
      default:
        this->add(a, ab, ca);
        this->add(ab, b, bc);
        this->add(ca, bc, c);
        this->add(ab, bc, ca);
        break;
    }
    return count > 0;
  }

  TriangleMesh& mesh_;
  std::vector<std::array<int, 2>>& parents_;
  double maxEdge_;
  const Checkpoint& checkpoint_;
  std::vector<std::array<int, 3>> middles_;
};

/// A lower bound of the number of triangles that edges of a length need: each has at most half its
/// square as area.
void requireFew(const TriangleMesh& mesh, double maxEdge)
{
  double triangles = 0.0;
  for (const auto& corners : mesh.triangles)
  {
    const glm::dvec3 a = positionOf(mesh, corners[0]);
    const glm::dvec3 u = positionOf(mesh, corners[1]) - a;
    const glm::dvec3 v = positionOf(mesh, corners[2]) - a;
    triangles += std::max(1.0, glm::length(glm::cross(u, v)) / (maxEdge * maxEdge));
  }
  if (triangles > static_cast<double>(kMaxTriangles))
  {
    std::ostringstream text;
    text << "edges of at most " << maxEdge << " need more than " << kMaxTriangles << " triangles";
    throw Error(ErrorCode::InvalidInput, text.str());
  }
}

} // namespace

Subdivision subdivide(const TriangleMesh& mesh, double maxEdge, const Execution& execution)
{
  if (!(maxEdge > 0.0 && std::isfinite(maxEdge)))
  {
    std::ostringstream text;
    text << "maximum edge length " << maxEdge << " is outside (0, infinity)";
    throw Error(ErrorCode::InvalidInput, text.str());
  }
  const Run run(execution);
  const Checkpoint checkpoint(run, 0.0, kPhase);
  try
  {
    Subdivision result;
    result.mesh = mesh;
    do
    {
      requireFew(result.mesh, maxEdge);
    } while (Pass(result, maxEdge, checkpoint).run());
    return result;
  }
  catch (const std::bad_alloc&)
  {
    throw Error(ErrorCode::OutOfMemory, "out of memory for a mesh with shorter edges");
  }
}

} // namespace medial
