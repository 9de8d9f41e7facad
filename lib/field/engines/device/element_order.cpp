#include "field/engines/device/element_order.h"

#include "base/hilbert_curve.h"
#include "base/order_statistics.h"

#include <glm/glm.hpp>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

namespace medial
{
namespace
{

/// A box around an element, world units.
struct ElementBox
{
  glm::dvec3 min;
  glm::dvec3 max;

  glm::dvec3 middle() const { return 0.5 * (min + max); }
  double radius() const { return 0.5 * glm::length(max - min); }
};

/// An element's place in the order.
struct Place
{
  int size; ///< 0 for those up to four times as large as the median, 1 up to a factor of 8, ...
  std::uint64_t code;
  std::int32_t site;

  bool operator<(const Place& other) const
  {
    return std::tie(size, code, site) < std::tie(other.size, other.code, other.site);
  }
};

std::vector<std::int32_t> elementsOf(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  const auto faces = static_cast<std::int32_t>(mesh.triangles.size());
  const auto edges = static_cast<std::int32_t>(connectivity.edges.size());
  std::vector<std::int32_t> elements;
  elements.reserve(mesh.triangles.size());
  for (std::int32_t face = 0; face < faces; ++face)
  {
    elements.push_back(face);
  }
  for (std::int32_t edge = 0; edge < edges; ++edge)
  {
    if (connectivity.edgeTriangles.size(edge) == 0)
    {
      elements.push_back(faces + edge);
    }
  }
  for (int point = 0; point < connectivity.pointEdges.rows(); ++point)
  {
    if (connectivity.pointEdges.size(point) == 0)
    {
      elements.push_back(faces + edges + point);
    }
  }
  return elements;
}

class ElementBoxes
{
public:
  ElementBoxes(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
    : mesh_(mesh)
    , connectivity_(connectivity)
  {
  }

  ElementBox operator()(std::int32_t site) const
  {
    const auto faces = static_cast<std::int32_t>(mesh_.triangles.size());
    const auto edges = static_cast<std::int32_t>(connectivity_.edges.size());
    if (site < faces)
    {
      const auto& t = mesh_.triangles[site];
      return this->around(t[0], t[1], t[2]);
    }
    if (site < faces + edges)
    {
      const auto& e = connectivity_.edges[site - faces];
      return this->around(e[0], e[1], e[1]);
    }
    const int point = site - faces - edges;
    return this->around(point, point, point);
  }

private:
  glm::dvec3 point(int id) const
  {
    const Point3& p = mesh_.points[id];
    return { p[0], p[1], p[2] };
  }
  ElementBox around(int a, int b, int c) const
  {
    const glm::dvec3 p = this->point(a);
    const glm::dvec3 q = this->point(b);
    const glm::dvec3 r = this->point(c);
    return { glm::min(p, glm::min(q, r)), glm::max(p, glm::max(q, r)) };
  }

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
};

HilbertCurve curveAround(const std::vector<ElementBox>& boxes)
{
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (const ElementBox& box : boxes)
  {
    low = glm::min(low, box.middle());
    high = glm::max(high, box.middle());
  }
  return { low, high };
}

double medianRadius(const std::vector<ElementBox>& boxes)
{
  std::vector<double> radii(boxes.size());
  std::transform(boxes.begin(), boxes.end(), radii.begin(),
    [](const ElementBox& box) { return box.radius(); });
  return medianOf(radii);
}

int sizeOf(double radius, double median)
{
  const double limit = 4.0 * median;
  return radius > limit && limit > 0.0 ? 1 + static_cast<int>(std::log2(radius / limit) / 3.0) : 0;
}

} // namespace

std::vector<std::int32_t> orderElements(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
{
  const std::vector<std::int32_t> elements = elementsOf(mesh, connectivity);
  const ElementBoxes boxOf(mesh, connectivity);
  std::vector<ElementBox> boxes(elements.size());
  tbb::parallel_for(std::size_t{ 0 }, elements.size(),
    [&](std::size_t i) { boxes[i] = boxOf(elements[i]); });
  const double median = medianRadius(boxes);
  const HilbertCurve curve = curveAround(boxes);
  std::vector<Place> places(elements.size());
  tbb::parallel_for(std::size_t{ 0 }, elements.size(),
    [&](std::size_t i)
    {
      places[i] = { sizeOf(boxes[i].radius(), median), curve.placeOf(boxes[i].middle()),
        elements[i] };
    });
  tbb::parallel_sort(places.begin(), places.end());
  std::vector<std::int32_t> order;
  order.reserve(places.size() + kGroupSize);
  const auto fillGroup = [&]
  {
    while (order.size() % kGroupSize != 0)
    {
      order.push_back(-1);
    }
  };
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (i > 0 && places[i].size != places[i - 1].size)
    {
      fillGroup();
    }
    order.push_back(places[i].site);
  }
  fillGroup();
  return order;
}

} // namespace medial
