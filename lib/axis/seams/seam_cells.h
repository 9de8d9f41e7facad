#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "axis/dual_mesh.h"
#include "axis/seams/cell_sides.h"
#include "field/crossing.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace medial
{

struct SiteSegment;

/// The grid cells along seams and curves and those beside them, with exact points where sheets meet
/// their edges. The cells of an axis have one point for each crossed edge, which may be a smooth
/// cell's; here are all of them.
class SeamCells
{
public:
  /// All arguments must outlive this.
  /// @param slices first slice of the cells and the end.
  SeamCells(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
    const glm::ivec2& slices);

  /// Vertices of the dual mesh; neighbouring ones are close together.
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }
  const DualMesh& mesh() const { return mesh_; }
  /// A place in or beside a cell on its side of the surface.
  const BisectorPoint& knownPoint(std::size_t vertex) const
  {
    return points_[slots_[*this->begin(vertex)]];
  }
  /// Calls visit(point) for the points on the edges of a cell.
  template <typename Visit>
  void forPoints(std::size_t vertex, const Visit& visit) const
  {
    for (const std::uint32_t* c = this->begin(vertex); c != this->end(vertex); ++c)
    {
      visit(points_[slots_[*c]]);
      for (auto other = this->firstOther(*c); other != others_.end() && other->first == *c; ++other)
      {
        visit(other->second);
      }
    }
  }
  /// Returns the sites that are closest in a cell or beside it.
  std::vector<SeenSite> sitesAround(std::size_t vertex) const;

private:
  using OtherPoint = std::pair<std::uint32_t, BisectorPoint>; ///< of a crossing

  const std::uint32_t* begin(std::size_t vertex) const
  {
    return mesh_.incident.data() + mesh_.offsets[vertex];
  }
  const std::uint32_t* end(std::size_t vertex) const
  {
    return mesh_.incident.data() + mesh_.offsets[vertex + 1];
  }
  std::vector<OtherPoint>::const_iterator firstOther(std::uint32_t crossing) const;
  bool hasSeam(std::size_t vertex) const;
  void findVertices(const glm::ivec2& slices);
  std::vector<std::uint32_t> numberPoints();
  void findPoints(const std::vector<std::uint32_t>& crossings);
  std::vector<OtherPoint> findPoints(const std::uint32_t* begin, const std::uint32_t* end);
  bool areTwoSides(int site, const SitePoint& near, const glm::dvec3& x) const;

  const AxisGeometry& geometry_;
  const std::vector<Crossing>& crossings_;
  DualMesh mesh_;
  std::vector<std::uint32_t> vertices_;
  std::vector<std::uint32_t> slots_;  ///< for each crossing the number of its point
  std::vector<BisectorPoint> points_; ///< one for each crossing of the cells
  std::vector<OtherPoint> others_;    ///< where more sheets cross an edge, ascending
};

} // namespace medial
