#include "ranks/axis/shared_thinning.h"

#include "base/memory_guard.h"
#include "medial/memory.h"
#include "ranks/collective.h"
#include "thinning/curve_probe.h"
#include "thinning/preserved_axis.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

namespace medial
{
namespace
{

/// Bytes for each point of the grid on the first rank: its distance, cells, voxels, sheets, and
/// what numbers the faces.
constexpr std::size_t kBytesAtFirst = 10;

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

} // namespace

SharedThinning::SharedThinning(const PreservationInput& input, const std::vector<Extent>& extents)
  : input_(input)
  , extents_(extents)
  , corners_(input.grid)
{
  if (this->isFirst())
  {
    requireMemory(input.grid.pointCount(), kBytesAtFirst);
  }
  distances_ = wholeDistances(input.communicator, input.values, input.grid, extents, input.side);
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
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    const Crossing& crossing = crossings[i];
    if (input_.part.share().owns(crossing.voxel))
    {
      const BisectorPoint& point = sheets->bisectors.points[i];
      own.push_back({ order.ofCrossing(crossing), crossing.voxel, crossing.axis, point.position,
        point.a.point, point.b.point, sheets->bisectors.moved[i], exact[i] });
    }
  }
  std::vector<SelectedRecord> all = medial::atFirst(input_.communicator, std::move(own));
  std::sort(all.begin(), all.end(),
    [](const SelectedRecord& a, const SelectedRecord& b) { return a.number < b.number; });
  selected_ = {};
  topology_ = {};
  for (const SelectedRecord& record : all)
  {
    selected_.crossings.push_back({ record.voxel, record.axis, -1, -1, false });
    selected_.bisectors.points.push_back({ record.position, { -1, record.a }, { -1, record.b } });
    selected_.bisectors.moved.push_back(record.moved);
    selected_.exact.push_back(record.exact);
  }
}

void SharedThinning::setColours(int colours, const std::vector<std::int32_t>& sites,
  const std::vector<int>& siteColours)
{
  colours_.resize(static_cast<std::size_t>(colours));
  std::iota(colours_.begin(), colours_.end(), 0);
  std::vector<std::int32_t>().swap(colourOfPoint_);
  if (colours < 2)
  {
    return;
  }
  RankLists<std::int32_t> lists = listsFor<std::int32_t>(input_.communicator);
  const Extent& own = input_.part.share().own();
  if (!own.empty())
  {
    visitWithin(own, input_.values.extent,
      [&](std::size_t i, std::size_t /*at*/) { lists.front().push_back(siteColours[sites[i]]); });
  }
  lists = exchanged(input_.communicator, std::move(lists));
  if (this->isFirst())
  {
    colourOfPoint_.resize(static_cast<std::size_t>(input_.grid.pointCount()));
    for (std::size_t rank = 0; rank < lists.size(); ++rank)
    {
      if (!lists[rank].empty())
      {
        visitWithin(extents_[rank], input_.part.share().whole(),
          [&](std::size_t i, std::size_t at) { colourOfPoint_[i] = lists[rank][at]; });
      }
    }
  }
}

std::vector<CornerCells> SharedThinning::thin(const ThinningPart& part, Side side, int colour,
  const Checkpoint& checkpoint)
{
  DepthField whole(distances_.data(), side, input_.part.field().frame().unit);
  if (!colourOfPoint_.empty())
  {
    whole.restrict(colourOfPoint_.data(), colours_.data(), colour);
  }
  std::optional<SolidThinning> thinning;
  std::vector<std::int64_t> edges; // position and axis
  this->atFirst(
    [&]
    {
      const std::vector<std::size_t> within =
        crossingsWithin(whole, input_.part.share().whole(), corners_.size(), selected_.crossings);
      thinning.emplace(whole, corners_.size(),
        someOf(within, selected_.crossings, selected_.bisectors, selected_.exact), checkpoint);
      add(thinning->topology(), topology_);
      for (int axis = 0; axis < 3; ++axis)
      {
        for (const CubeCell edge : cellsOf(thinning->complex(), kEdgeKind + axis))
        {
          edges.push_back(3 * static_cast<std::int64_t>(CubicalComplex::index(edge)) + axis);
        }
      }
    });
  const std::vector<std::uint8_t> answers = this->separating(part, edges);
  std::vector<CornerCells> left;
  this->atFirst(
    [&]
    {
      const GridFrame& frame = input_.part.field().frame();
      CubicalComplex separating(corners_.size());
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        if (answers[i] != 0)
        {
          separating.insert(8 * (edges[i] / 3) + kEdgeKind + edges[i] % 3);
        }
      }
      std::vector<std::int64_t>().swap(edges);
      const MedialAxisOptions& options = input_.options;
      thinning->burn([&](CubeCell edge) { return separating.has(edge); }, frame.step,
        { glm::radians(options.angle), options.lambda / frame.unit, options.radius / frame.unit });
      const CubicalComplex& complex = thinning->complex();
      for (const CubeCell vertex : cellsOf(complex, kVertexKind))
      {
        const std::size_t position = CubicalComplex::index(vertex);
        left.emplace_back(static_cast<std::int64_t>(position), complex.bits(position));
      }
    });
  return left;
}

/// Asks the ranks which edges curves may follow.
/// @param edges on the first rank.
std::vector<std::uint8_t> SharedThinning::separating(const ThinningPart& part,
  const std::vector<std::int64_t>& edges) const
{
  std::optional<CubicalComplex> here;
  std::optional<CurveProbe> probe;
  if (part.geometry != nullptr)
  {
    here.emplace(input_.values.extent, corners_.size());
    probe.emplace(part.geometry->sites, part.geometry->frame, part.closestSites.data(), part.depth,
      part.geometry->limits.angle);
  }
  return answered(
    input_.communicator, edges,
    [&](std::int64_t edge)
    {
      // Where the lowest of the voxels around is.
      glm::ivec3 voxel = corners_.position(edge / 3);
      const auto axis = static_cast<int>(edge % 3);
      --voxel[(axis + 1) % 3];
      --voxel[(axis + 2) % 3];
      return input_.part.share().ownerOf(voxel);
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
  selected_ = {};
  std::vector<float>().swap(distances_);
  std::vector<std::int32_t>().swap(colourOfPoint_);
}

} // namespace medial
