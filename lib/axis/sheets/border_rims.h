#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/edge_table.h"
#include "axis/sheets/border_finder.h"
#include "axis/sheets/sheet_selection.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// Moves rims as moveToBorders(), step by step: for an axis in pieces, whose rims go on in others.
class BorderRims
{
public:
  /// Rounds of beginRound(), passes of smooth(), and settle().
  static constexpr int kRounds = 3;
  static constexpr int kPasses = 40;
  /// A neighbour on the rim where there is none, or where there are several.
  static constexpr int kNone = -1;
  static constexpr int kJunction = -2;

  /// Finds the borders. The arguments are those of moveToBorders(), and must outlive this.
  BorderRims(const AxisGeometry& geometry, const SheetSelection& selection,
    const std::vector<EdgeTable::Edge>& rims, const std::vector<std::size_t>& origins,
    BisectorPoints& points);

  /// Number of vertices of rims.
  std::size_t size() const { return walkers_.size(); }
  /// The i-th of them, which ascend.
  std::size_t vertex(std::size_t i) const { return walkers_[i].vertex; }
  /// Returns its two neighbours, where it has just two.
  const std::array<int, 2>& neighbours(std::size_t i) const { return neighbours_[i]; }
  /// Where it is on its way to.
  const glm::dvec3& place(std::size_t i) const { return places_[i]; }
  void setPlace(std::size_t i, const glm::dvec3& place);
  /// Lets a vertex stay where it is, unless setPlace() moves it.
  void hold(std::size_t i) { walkers_[i].movable = false; }

  /// Finds out which vertices smooth() moves. Everything that smoothing needs is there then: it
  /// cannot fail.
  void beginRound();
  /// Smooths the lines of rims once.
  /// @param pass in [0, kPasses).
  void smooth(int pass);
  /// Puts vertices onto the bisector at their places.
  void settle();
  /// Returns the vertices that have no border.
  std::vector<std::size_t> elsewhere() const;

private:
  /// What smoothing reads of a vertex that it moves.
  struct FreeVertex
  {
    std::size_t walker;
    std::array<int, 2> neighbours;
    glm::dvec3 normal;
  };

  void lendSheets();

  const AxisGeometry& geometry_;
  BisectorPoints& points_;
  std::vector<BorderWalker> walkers_;
  std::vector<std::uint32_t> order_; ///< so that those in a row are close together
  std::vector<std::array<int, 2>> neighbours_;
  std::vector<glm::dvec3> places_;
  std::vector<glm::dvec3> before_; ///< the places before the last pass
  std::vector<FreeVertex> free_;   ///< those that smoothing moves
  std::vector<std::uint8_t> settled_;
};

/// Moves the rims of sheets to the borders of what is selected: to where the separation angle,
/// lambda or the radius of the sheet reaches its limit, or to the seam at which the sheet ends. The
/// cells stay as they are, so neighbours share the border and no crack opens.
///
/// A rim is about a grid cell away from its border at most. Its vertices go to the nearest place
/// where a SheetFit reaches the limit, or where another site is nearer. The line that they form is
/// smoothed, since facets make it jagged, and put onto the bisector.
/// @param rims edges of one quad only.
/// @param origins for each vertex that of the samples' mesh.
/// @param points of the vertices.
/// @return the vertices of rims that have no border.
std::vector<std::size_t> moveToBorders(const AxisGeometry& geometry,
  const SheetSelection& selection, const std::vector<EdgeTable::Edge>& rims,
  const std::vector<std::size_t>& origins, BisectorPoints& points);

} // namespace medial
