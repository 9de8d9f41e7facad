#pragma once

#include "axis/axis_geometry.h"
#include "axis/bisector.h"
#include "axis/sheets/sheet_fit.h"
#include "axis/sheets/sheet_selection.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace medial
{

/// A rim vertex on its way to the border.
struct BorderWalker
{
  std::size_t vertex = 0;
  bool onSheet = false;    ///< alone: no other sheet meets it there
  bool atBorder = false;   ///< whether `place` is at a border
  bool exact = false;      ///< whether facets do not matter to that border
  bool movable = false;    ///< whether the rim may move: it does not lead to a crease
  bool nearCrease = false; ///< whether its ball is as small as near a crease
  SheetFit fit;
  std::vector<int> sites; ///< of the sheet
  BisectorPoint sample;   ///< of the same sheet
  glm::dvec3 place{ 0.0 };
};

/// Finds the borders of sheets near the vertices of their rims.
class BorderFinder
{
public:
  /// @param points of vertices.
  /// @param origins of the same vertices: those of the samples' mesh. All must outlive this.
  BorderFinder(const AxisGeometry& geometry, const SheetSelection& selection,
    const BisectorPoints& points, const std::vector<std::size_t>& origins);

  /// Fills walkers, whose vertices are given.
  void find(const std::vector<BorderWalker*>& walkers);

private:
  /// A crossing at a vertex.
  struct AtVertex
  {
    std::size_t crossing;
    bool alone; ///< whether all crossings of the vertex are on the same sheet
  };

  std::optional<AtVertex> crossingAt(std::size_t origin) const;
  void fit(BorderWalker& walker);
  void findSeams(const std::vector<BorderWalker*>& walkers) const;
  void moveToSeam(const SiteQuery::Question& beyond, BorderWalker& walker) const;

  const AxisGeometry& geometry_;
  const SheetSelection& selection_;
  const BisectorPoints& points_;
  const std::vector<std::size_t>& origins_;
  SheetFitter fitter_;
};

} // namespace medial
