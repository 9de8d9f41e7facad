#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector_point.h"
#include "axis/dual_mesh.h"
#include "field/crossing.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// A bisector point in each grid cell that has one.
struct CellPoints
{
  std::vector<BisectorPoint> points; ///< for each vertex of a dual mesh
  std::vector<std::uint8_t> found;   ///< for each vertex not 0 if it has a point

  /// Whether a vertex has a point. There may be no cells, or no such vertex (kNoVertex).
  bool has(std::size_t vertex) const { return vertex < found.size() && found[vertex] != 0; }
};

/// Finds exact bisector points in the cells that one smooth sheet crosses, by one query each,
/// mostly. The bisector points of crossings take one and a half each, and the vertices of the dual
/// mesh another one.
class SmoothCells
{
public:
  /// All arguments must outlive this.
  /// @param guesses where crossings meet the sheet, roughly, with the two sites of each.
  SmoothCells(const AxisGeometry& geometry, const std::vector<Crossing>& crossings,
    const DualMesh& mesh, const std::vector<BisectorPoint>& guesses);

  /// Finds the points of cells whose closest pairs at all crossings turn by no more than
  /// kMaxTurn.
  /// @param wanted for each crossing whether it counts; cells with others have no point.
  CellPoints find(const std::vector<std::uint8_t>& wanted) const;

private:
  struct Candidate;

  std::optional<Candidate> candidateIn(std::size_t vertex,
    const std::vector<std::uint8_t>& wanted) const;
  bool moveToBisector(Candidate& candidate) const;
  void prove(std::vector<Candidate>& candidates, CellPoints& cells) const;
  bool replaceBy(const SitePoint& third, Candidate& candidate) const;

  const AxisGeometry& geometry_;
  const std::vector<Crossing>& crossings_;
  const DualMesh& mesh_;
  const std::vector<BisectorPoint>& guesses_;
};

} // namespace medial
