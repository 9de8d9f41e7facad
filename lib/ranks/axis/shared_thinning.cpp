#include "ranks/axis/shared_thinning.h"

#include "base/memory_guard.h"
#include "base/sorted_set.h"
#include "ranks/axis/corner_cells.h"
#include "ranks/axis/depth_requests.h"
#include "ranks/axis/shared_solid.h"
#include "ranks/collective.h"
#include "thinning/curve_probe.h"
#include "thinning/preserved_axis.h"
#include "thinning/solid_core.h"
#include "thinning/undecided_voxels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

/// What the first rank reads of a selected crossing.
struct SelectedRecord
{
  std::int64_t number; ///< as AxisOrder
  glm::ivec3 voxel;
  int axis;
  glm::dvec3 position;
  glm::dvec3 a;
  glm::dvec3 b;
  std::uint8_t moved;
  std::uint8_t exact;
};

/// Returns the positions of a complex that have a vertex, with their cells.
std::vector<CornerCells> cornersOf(const CubicalComplex& complex)
{
  std::vector<CornerCells> corners;
  for (const CubeCell vertex : cellsOf(complex, kVertexKind))
  {
    const std::size_t position = CubicalComplex::index(vertex);
    corners.emplace_back(static_cast<std::int64_t>(position), complex.bits(position));
  }
  return corners;
}

/// Returns the edges of a complex: three times their positions, and their axes.
std::vector<std::int64_t> edgesOf(const CubicalComplex& complex)
{
  std::vector<std::int64_t> edges;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const CubeCell edge : cellsOf(complex, kEdgeKind + axis))
    {
      edges.push_back(3 * static_cast<std::int64_t>(CubicalComplex::index(edge)) + axis);
    }
  }
  return edges;
}

/// Returns the cells of some edges, as edgesOf() has them.
/// @param wanted for each not 0 if it is one of them.
CubicalComplex cellsOfEdges(const glm::ivec3& size, const std::vector<std::int64_t>& edges,
  const std::vector<std::uint8_t>& wanted)
{
  CubicalComplex cells(size);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (wanted[i] != 0)
    {
      cells.insert(8 * (edges[i] / 3) + kEdgeKind + edges[i] % 3);
    }
  }
  return cells;
}

/// Loads what the fire looks at, but for little.
void loadAround(const CubicalComplex& complex, SparseVoxels& voxels)
{
  std::vector<std::size_t> around;
  for (const CubeCell vertex : cellsOf(complex, kVertexKind))
  {
    around.push_back(CubicalComplex::index(vertex));
  }
  voxels.loadAround(around, 1);
}

} // namespace

SharedThinning::SharedThinning(const PreservationInput& input)
  : input_(input)
  , corners_(input.grid)
{
}

template <typename Work>
void SharedThinning::atFirst(const Work& work) const
{
  if (this->isFirst())
  {
    withMemoryErrors(input_.grid.pointCount(), [&] { input_.part.run().onThreads(work); });
  }
}

void SharedThinning::select(const std::vector<Crossing>& crossings, const SheetSelection* sheets)
{
  const AxisOrder order(input_.grid);
  std::vector<SelectedRecord> own;
  const std::vector<std::uint8_t> exact =
    sheets != nullptr ? exactPairs(*sheets) : std::vector<std::uint8_t>();
  own_.clear();
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const Crossing& crossing = crossings[i];
    if (input_.part.share().owns(crossing.voxel))
    {
      const BisectorPoint& point = sheets->bisectors.points[i];
      own.push_back({ order.ofCrossing(crossing), crossing.voxel, crossing.axis, point.position,
        point.a.point, point.b.point, sheets->bisectors.moved[i], exact[i] });
      own_.push_back(crossing);
    }
  }
  std::vector<SelectedRecord> all = medial::atFirst(input_.communicator, std::move(own));
  std::sort(all.begin(), all.end(),
    [](const SelectedRecord& a, const SelectedRecord& b) { return a.number < b.number; });
  selected_ = {};
  numbers_.clear();
  topology_ = {};
  for (const SelectedRecord& record : all)
  {
    selected_.crossings.push_back({ record.voxel, record.axis, -1, -1, false });
    selected_.bisectors.points.push_back({ record.position, { -1, record.a }, { -1, record.b } });
    selected_.bisectors.moved.push_back(record.moved);
    selected_.exact.push_back(record.exact);
    numbers_.push_back(record.number);
  }
}

/// Returns the selected crossings that lie in a solid, on the first rank.
SelectedCrossings SharedThinning::selectedWithin(const ThinningPart& part) const
{
  const AxisOrder order(input_.grid);
  std::vector<std::int64_t> own;
  input_.part.locally(
    [&]
    {
      for (const std::size_t i :
        crossingsWithin(part.depth, part.field.extent(), corners_.size(), own_))
      {
        own.push_back(order.ofCrossing(own_[i]));
      }
    });
  std::vector<std::int64_t> all = medial::atFirst(input_.communicator, std::move(own));
  std::sort(all.begin(), all.end());
  std::vector<std::size_t> indices;
  for (const std::int64_t number : all)
  {
    indices.push_back(static_cast<std::size_t>(indexIn(numbers_, number)));
  }
  SelectedCrossings selected;
  this->atFirst(
    [&] { selected = someOf(indices, selected_.crossings, selected_.bisectors, selected_.exact); });
  return selected;
}

/// Returns the undecided voxels of the whole solid on the first rank.
/// @param part where ranks find them.
/// @param here the solid there and in a layer around.
/// @param thinning that has the sheets; null but on the first rank.
std::vector<std::size_t> SharedThinning::undecided(const RankPart& part, const SolidVoxels& here,
  const SolidThinning* thinning, const Checkpoint& checkpoint) const
{
  const std::vector<CornerCells> cells = sentCells(input_.communicator, corners_,
    thinning != nullptr ? cornersOf(thinning->complex()) : std::vector<CornerCells>(),
    [&](int rank) { return grownUpwards(part.share().of(rank), 1, part.share().whole()); });
  std::vector<std::int64_t> own;
  part.locally(
    [&]
    {
      CubicalComplex sheets(here.part(), corners_.size());
      insertCells(corners_, cells, sheets);
      for (const std::size_t voxel : undecidedVoxels(here, voxelsOf(here), sheets, checkpoint))
      {
        own.push_back(corners_.of(sheets.position(8 * static_cast<CubeCell>(voxel))));
      }
    });
  const std::vector<std::int64_t> all = medial::atFirst(input_.communicator, std::move(own));
  std::vector<std::size_t> voxels(all.begin(), all.end());
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

std::vector<CornerCells> SharedThinning::thin(const ThinningPart& part,
  const Checkpoint& checkpoint)
{
  const RankPart& fieldPart = part.keptField.part();
  const SolidVoxels here(part.keptDepth, part.keptField.extent(), corners_.size());
  SelectedCrossings selected = this->selectedWithin(part);
  add(topologyOf(input_.communicator, fieldPart, here), topology_);
  std::optional<SolidThinning> thinning;
  this->atFirst([&] { thinning.emplace(corners_.size(), std::move(selected), checkpoint); });
  const std::vector<std::size_t> undecided =
    this->undecided(fieldPart, here, thinning ? &*thinning : nullptr, checkpoint);
  DepthRequests depths(input_.communicator, fieldPart.share(), part.keptDepth,
    part.keptField.extent());
  std::vector<std::int64_t> edges;
  const auto findCore = [&](SparseVoxels& voxels)
  {
    thinning->addCore(
      coreOf(voxels, thinning->complex(), thinning->crossings(), undecided, checkpoint));
    edges = edgesOf(thinning->complex());
  };
  depths.during([&](SparseVoxels& voxels) { this->atFirst([&] { findCore(voxels); }); });
  const std::vector<std::uint8_t> answers = this->separating(part, edges);
  std::vector<CornerCells> left;
  const auto burn = [&](SparseVoxels& voxels)
  {
    const CubicalComplex separating = cellsOfEdges(corners_.size(), edges, answers);
    loadAround(thinning->complex(), voxels);
    const GridFrame& frame = input_.part.field().frame();
    const MedialAxisOptions& options = input_.options;
    thinning->burn([&](std::size_t voxel) { return voxels.at(voxel); },
      [&](CubeCell edge) { return separating.has(edge); }, frame.step,
      { glm::radians(options.angle), options.lambda / frame.unit, options.radius / frame.unit });
    left = cornersOf(thinning->complex());
  };
  depths.during([&](SparseVoxels& voxels) { this->atFirst([&] { burn(voxels); }); });
  return left;
}

/// Asks the ranks which edges curves may follow.
/// @param edges on the first rank.
std::vector<std::uint8_t> SharedThinning::separating(const ThinningPart& part,
  const std::vector<std::int64_t>& edges) const
{
  const auto voxelsAround = [&](std::int64_t edge)
  {
    const glm::ivec3 last = corners_.position(edge / 3);
    const auto axis = static_cast<int>(edge % 3);
    glm::ivec3 u(0);
    glm::ivec3 v(0);
    u[(axis + 1) % 3] = 1;
    v[(axis + 2) % 3] = 1;
    return std::array<glm::ivec3, 4>{ last - u - v, last - v, last - u, last };
  };
  std::optional<CubicalComplex> here;
  std::optional<CurveProbe> probe;
  if (part.geometry != nullptr)
  {
    here.emplace(part.field.extent(), corners_.size());
    probe.emplace(part.geometry->sites, part.geometry->frame, part.field.closestSites(), part.depth,
      part.geometry->limits.angle);
  }
  return answered(
    input_.communicator, edges,
    [&](std::int64_t edge) { return input_.part.share().ownerOf(voxelsAround(edge).front()); },
    [&](const RankLists<std::int64_t>& asked)
    {
      for (const std::vector<std::int64_t>& list : asked)
      {
        for (const std::int64_t edge : list)
        {
          const std::array<glm::ivec3, 4> voxels = voxelsAround(edge);
          std::for_each(voxels.begin(), voxels.end(),
            [&](const glm::ivec3& voxel) { part.field.want(voxel); });
        }
      }
      part.field.bring();
    },
    [&](std::int64_t edge) -> std::uint8_t
    {
      const CubeCell cell =
        here->cell(corners_.position(edge / 3), kEdgeKind + static_cast<int>(edge % 3));
      return probe->separates(*here, cell) ? 1 : 0;
    });
}

void SharedThinning::finish()
{
  std::vector<Crossing>().swap(own_);
  selected_ = {};
  std::vector<std::int64_t>().swap(numbers_);
}

} // namespace medial
