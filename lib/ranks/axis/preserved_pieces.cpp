#include "ranks/axis/preserved_pieces.h"

#include "axis/sheets/border_rims.h"
#include "axis/sheets/crease_rims.h"
#include "base/extents.h"
#include "ranks/axis/asked_field.h"
#include "ranks/axis/corner_cells.h"
#include "ranks/axis/curve_pieces.h"
#include "ranks/axis/sites_here.h"
#include "ranks/collective.h"
#include "thinning/preserved_axis.h"
#include "thinning/rim_finish.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// How far around its part a rank knows the axis without moving rims, grid cells: what is around
/// the points that its cells use.
constexpr int kAround = 3;

void replaceSites(BisectorPoint& point, const std::vector<std::int32_t>& numbers)
{
  point.a.site = numbers[point.a.site];
  point.b.site = numbers[point.b.site];
}

/// Finds the vertices of a dual mesh by their grid cells and sides.
class VertexFinder
{
public:
  /// @param crossings of the mesh.
  VertexFinder(const AxisOrder& order, const DualSubmesh& part,
    const std::vector<Crossing>& crossings)
    : order_(order)
    , part_(part)
  {
    for (std::size_t v = 0; v < part.mesh.cells.size(); ++v)
    {
      const Crossing& crossing = crossings[part.mesh.incident[part.mesh.offsets[v]]];
      numbers_.push_back(order.ofVertex(part.mesh.cells[v], crossing.inside));
    }
  }

  /// Returns the vertex of the selection's samples in a grid cell, or kNoVertex.
  std::size_t find(const glm::ivec3& cell, bool inside) const
  {
    const std::int64_t number = order_.ofVertex(cell, inside);
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), number);
    return found != numbers_.end() && *found == number
      ? part_.origins[static_cast<std::size_t>(found - numbers_.begin())]
      : kNoVertex;
  }

private:
  const AxisOrder& order_;
  const DualSubmesh& part_;
  std::vector<std::int64_t> numbers_; ///< of the vertices, ascending
};

} // namespace

struct PreservedPieces::Part
{
  const AxisGeometry* geometry; ///< null without a part
  int halo;
  const Checkpoint& checkpoint;
  std::vector<Crossing> crossings;          ///< those that are selected
  const std::vector<std::int32_t>& numbers; ///< of the sites here
  const SitesHere& sites;
  AskedField& field; ///< in the part and a layer around
  std::optional<SheetSelection> selection;
};

/// A point of an axis, whose sites have their numbers in the whole surface.
struct PreservedPieces::CornerRecord
{
  std::int64_t number; ///< as CornerNumbers
  BisectorPoint point;
  std::uint8_t moved;
  std::uint8_t onSheet; ///< not 0 if the selection's samples have a vertex there
};

PreservedPieces::PreservedPieces(const PreservationInput& input, const RankPart& fieldPart,
  FieldPart values)
  : input_(input)
  , corners_(input.grid)
  , order_(input.grid)
  , thinning_(input)
  , field_(std::in_place, input.communicator, fieldPart, input.grid, std::move(values), input.side)
{
}

bool PreservedPieces::tryHalo(const AxisGeometry* geometry, std::vector<Crossing> crossings,
  int halo, const Checkpoint& checkpoint)
{
  const std::vector<std::int32_t> numbers = input_.part.field().siteNumbers();
  const SitesHere sites(numbers);
  AskedField field(*field_, sites, input_.part.share().withHalo(1));
  Part part{ geometry, halo, checkpoint, std::move(crossings), numbers, sites, field, {} };
  input_.part.locally([&] { part.selection.emplace(selectSheets(*geometry, part.crossings)); });
  thinning_.select(part.crossings, part.selection ? &*part.selection : nullptr);
  input_.part.locally(
    [&]
    {
      for (const Crossing& crossing : part.crossings)
      {
        field.take(*geometry, crossing);
      }
    });
  field.bring();
  const std::vector<int> siteColours = field_->siteColours();
  const double unit = input_.part.field().frame().unit;
  solids_.clear();
  for (const Side side : sidesOf(input_.part.field().hasSign(), input_.side))
  {
    const int colours = field_->colours(side);
    for (int colour = 0; colour < colours; ++colour)
    {
      DepthField depth(field.distances(), side, unit);
      if (colours > 1)
      {
        depth.restrict(field.closestSites(), siteColours.data(), colour);
      }
      if (!this->addSolid(part, { geometry, field, depth, *field_, field_->depth(side, colour) },
            side))
      {
        return false;
      }
    }
  }
  thinning_.finish();
  field_.reset();
  return true;
}

/// Thins a solid, and makes its points in the part and around.
/// @return false on every rank if the halo is too narrow.
bool PreservedPieces::addSolid(const Part& part, const ThinningPart& known, Side side)
{
  const int halo = this->wantsSurface() ? part.halo : kAround;
  SolidPiece solid;
  solid.side = side;
  const std::vector<CornerCells> cells =
    this->sendCells(thinning_.thin(known, part.checkpoint), halo);
  const bool complete = this->setPoints(part, known.depth, cells, solid);
  if (this->wantsSurface())
  {
    const std::vector<BisectorPoint> before = solid.axis.points.points;
    if ((maximum(input_.communicator, complete ? 0 : 1) != 0 || !this->moveRims(part, solid)) &&
      !input_.part.coversGrid(part.halo))
    {
      return false;
    }
    keepSound(input_.communicator, input_.part.share(), corners_, before, solid);
  }
  solids_.push_back(std::move(solid));
  return true;
}

/// Sends cells from the first rank to where they are, and to a halo.
std::vector<CornerCells> PreservedPieces::sendCells(const std::vector<CornerCells>& cells,
  int halo) const
{
  return sentCells(input_.communicator, corners_, cells,
    [&](int rank)
    {
      const GridShare& share = input_.part.share();
      return grownUpwards(share.withHalo(rank, halo), kTold, share.whole());
    });
}

/// The corners of this rank that the fire leaves, and what is around them.
struct PreservedPieces::Corners
{
  CubicalComplex complex;
  std::vector<CubeCell> vertices;
  std::vector<std::size_t> within; ///< which of the part's crossings are in the solid
  AxisSamples samples;             ///< of these
};

/// Finds the corners of this rank, and asks for the field around those that are on no sheet.
std::optional<PreservedPieces::Corners> PreservedPieces::cornersOf(const Part& part,
  const DepthField& depth, const std::vector<CornerCells>& cells) const
{
  std::optional<Corners> corners;
  input_.part.locally(
    [&]
    {
      CubicalComplex complex(part.field.extent(), corners_.size());
      std::vector<CubeCell> vertices;
      for (const CornerCells left : cells)
      {
        const glm::ivec3 position = corners_.position(left.position());
        if (complex.covers(position))
        {
          const CubeCell vertex = complex.cell(position, kVertexKind);
          complex.insert(CubicalComplex::index(vertex), left.bits());
          if (input_.part.share().owns(position - 1))
          {
            vertices.push_back(vertex);
          }
        }
      }
      const SheetSelection& selection = *part.selection;
      std::vector<std::size_t> within =
        crossingsWithin(depth, part.field.extent(), corners_.size(), part.crossings);
      SelectedCrossings selected =
        someOf(within, part.crossings, selection.bisectors, exactPairs(selection));
      AxisSamples samples(complex, selected.crossings, std::move(selected.bisectors));
      for (const CubeCell vertex : vertices)
      {
        if (!isOnSheet(complex, samples, vertex))
        {
          for (const glm::ivec3& voxel : voxelsAround(complex, vertex))
          {
            part.field.wantBits(voxel);
          }
        }
      }
      corners.emplace(
        Corners{ std::move(complex), std::move(vertices), std::move(within), std::move(samples) });
    });
  return corners;
}

/// Places the points of this rank.
std::vector<PreservedPieces::CornerRecord> PreservedPieces::placed(const Part& part,
  const DepthField& depth, const std::vector<CornerCells>& cells) const
{
  std::optional<Corners> corners = this->cornersOf(part, depth, cells);
  part.field.bring();
  std::vector<CornerRecord> own;
  input_.part.locally(
    [&]
    {
      const std::vector<CubeCell>& vertices = corners->vertices;
      const ThinnedAxis placed = pointsOfCorners(corners->complex, vertices, depth,
        { *part.geometry, part.field.closestSites() }, { *part.selection, corners->within },
        input_.options.representation, corners->samples);
      for (std::size_t i = 0; i < vertices.size(); ++i)
      {
        own.push_back({ corners_.of(placed.gridCells[i] + 1, solids_.size()),
          placed.points.points[i], placed.points.moved[i],
          static_cast<std::uint8_t>(placed.origins[i] != kNoVertex ? 1 : 0) });
        replaceSites(own.back().point, part.numbers);
      }
    });
  return own;
}

/// Places the points of this rank, and gets those around from others.
/// @param cells of the part and a halo.
/// @return false if sites of those around are not here.
bool PreservedPieces::setPoints(const Part& part, const DepthField& depth,
  const std::vector<CornerCells>& cells, SolidPiece& solid) const
{
  const int halo = this->wantsSurface() ? part.halo : kAround;
  const GridShare& share = input_.part.share();
  const std::vector<CornerRecord> own = this->placed(part, depth, cells);
  std::vector<CornerRecord> around = share.spread(input_.communicator, own, halo,
    [&](const CornerRecord& record) { return corners_.cell(record.number); });
  std::sort(around.begin(), around.end(),
    [](const CornerRecord& a, const CornerRecord& b) { return a.number < b.number; });
  if (part.geometry == nullptr)
  {
    return true;
  }
  const VertexFinder vertices(order_, part.selection->part, part.crossings);
  CubicalComplex complex(grownUpwards(share.withHalo(halo), kTold, share.whole()), corners_.size());
  insertCells(corners_, cells, complex);
  bool found = true;
  std::vector<CubeCell> cubeCells;
  for (CornerRecord& record : around)
  {
    BisectorPoint& point = record.point;
    for (std::int32_t* const site : { &point.a.site, &point.b.site })
    {
      *site = part.sites.find(*site);
      found = found && *site >= 0;
      *site = std::max(0, *site);
    }
    const glm::ivec3 cell = corners_.cell(record.number);
    cubeCells.push_back(complex.cell(cell + 1, kVertexKind));
    solid.numbers.push_back(record.number);
    solid.own.push_back(share.owns(cell) ? 1 : 0);
    solid.axis.points.points.push_back(point);
    solid.axis.points.moved.push_back(record.moved);
    solid.axis.gridCells.push_back(cell);
    solid.axis.origins.push_back(
      record.onSheet != 0 ? vertices.find(cell, solid.side == Side::Interior) : kNoVertex);
  }
  addCells(complex, cubeCells, solid.axis);
  return found || !this->wantsSurface();
}

/// Gives the rims of all ranks the finish of a selected surface.
/// @return false on every rank if some have seen them differently.
bool PreservedPieces::moveRims(const Part& part, SolidPiece& solid) const
{
  std::optional<BorderRims> rims;
  input_.part.locally(
    [&]
    {
      rims.emplace(*part.geometry, *part.selection, selectedRims(solid.axis), solid.axis.origins,
        solid.axis.points);
    });
  const RimExchange::Vertices vertices{ [&](std::size_t vertex) { return solid.numbers[vertex]; },
    [&](std::size_t vertex) { return solid.axis.gridCells[vertex]; } };
  if (!input_.part.moveRims(input_.communicator, vertices, rims ? &*rims : nullptr))
  {
    return false;
  }
  input_.part.locally(
    [&]
    {
      std::vector<std::size_t> own;
      const std::vector<std::size_t> elsewhere = rims->elsewhere();
      std::copy_if(elsewhere.begin(), elsewhere.end(), std::back_inserter(own),
        [&](std::size_t vertex) { return solid.own[vertex] != 0; });
      extendRims(*part.geometry, own, solid.axis.points);
    });
  return true;
}

/// Returns the lines of all solids, and the quads that they end at.
AxisPatch PreservedPieces::cellsAtCurves() const
{
  std::vector<NumberedCorners> cells;
  std::vector<MovedCorner> corners;
  for (const SolidPiece& solid : solids_)
  {
    const std::vector<BisectorPoint>& points = solid.axis.points.points;
    std::vector<std::uint8_t> onLine(points.size(), 0);
    std::vector<std::uint8_t> used(points.size(), 0);
    const auto use = [&](const auto& cell)
    {
      if (solid.own[cell.front()] != 0)
      {
        cells.push_back(solid.numbered(cell));
      }
      std::for_each(cell.begin(), cell.end(), [&](std::int64_t p) { used[p] = 1; });
    };
    for (const auto& line : solid.axis.lines)
    {
      use(line);
      onLine[line[0]] = 1;
      onLine[line[1]] = 1;
    }
    for (const auto& quad : solid.axis.quads)
    {
      if (std::any_of(quad.begin(), quad.end(), [&](std::int64_t p) { return onLine[p] != 0; }))
      {
        use(quad);
      }
    }
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      if (used[p] != 0 && solid.own[p] != 0)
      {
        corners.push_back({ solid.numbers[p], points[p], points[p] });
      }
    }
  }
  const std::vector<std::int32_t> numbers = input_.part.field().siteNumbers();
  for (MovedCorner& corner : corners)
  {
    replaceSites(corner.before, numbers);
    replaceSites(corner.after, numbers);
  }
  return AxisPatch(input_.communicator, corners, cells);
}

/// Tells all who have a point where it is now.
void PreservedPieces::tellChanges(const AxisPatch& patch)
{
  RankLists<ChangedCorner> lists = listsFor<ChangedCorner>(input_.communicator);
  for (std::size_t p = 0; p < patch.numbers.size(); ++p)
  {
    const BisectorPoint& point = patch.axis.points.points[p];
    if (point.position == patch.before[p].position)
    {
      continue;
    }
    for (std::size_t rank = 0; rank < lists.size(); ++rank)
    {
      if (hasPoint(input_.part.share().withHalo(static_cast<int>(rank), kTold),
            corners_.cell(patch.numbers[p])))
      {
        lists[rank].push_back({ patch.numbers[p], point });
      }
    }
  }
  for (const ChangedCorner& corner : flattened(exchanged(input_.communicator, std::move(lists))))
  {
    SolidPiece& solid = solids_[static_cast<std::size_t>(corner.number / corners_.count())];
    const std::size_t p = solid.find(corner.number);
    if (p < solid.numbers.size())
    {
      solid.axis.points.points[p] = corner.point;
    }
  }
}

void PreservedPieces::finishCurves(const Checkpoint& checkpoint)
{
  if (this->wantsSurface())
  {
    AxisPatch patch = this->cellsAtCurves();
    straightenCurves(input_, corners_, checkpoint, patch);
    this->tellChanges(patch);
  }
}

AxisPiece PreservedPieces::piece(BisectorPoints& points) const
{
  AxisPiece piece = pieceOf(input_.communicator, corners_, solids_, points);
  piece.axis.solid = gathered(input_.communicator, thinning_.topology()).front();
  return piece;
}

} // namespace medial
