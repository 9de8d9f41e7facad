#include "thinning/thinned_axis.h"

#include "axis/closest_pairs.h"
#include "axis/dual_mesh.h"
#include "axis/sheets/axis_points.h"
#include "axis/tile_order.h"
#include "sites/closest_point.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>

namespace medial
{
namespace
{

/// Samples count if their separation angle is at least this share of the widest around a point.
constexpr double kWideShare = 0.5;

/// Up to as many values as there are faces around a corner.
template <typename T>
struct AroundCorner
{
  std::array<T, 12> values;
  int count = 0;

  void add(T value) { values[count++] = value; }
  const T* begin() const { return values.data(); }
  const T* end() const { return values.data() + count; }
};

/// The origin of the point of a corner.
struct Origin
{
  AroundCorner<CubeCell> faces;
  bool onSheet = false; ///< whether selected faces are left
  bool widestOnly = false;
};

class CornerPlacer
{
public:
  CornerPlacer(const CubicalComplex& complex, std::vector<CubeCell> vertices,
    const DepthField& depth, const SampleContext& context, const SelectedSamples& selected,
    AxisSamples& samples)
    : complex_(complex)
    , depth_(depth)
    , context_(context)
    , selected_(selected)
    , samples_(samples)
    , vertices_(std::move(vertices))
  {
  }

  ThinnedAxis place(Representation representation)
  {
    ThinnedAxis cells;
    this->findSamples(cells);
    this->placePoints(representation, cells);
    cells.gridCells = mesh_.cells;
    return cells;
  }

private:
  void findSamples(ThinnedAxis& cells)
  {
    const std::size_t count = vertices_.size();
    std::vector<Origin> origins(count);
    tbb::parallel_for(std::size_t{ 0 }, count,
      [&](std::size_t i) { origins[i] = this->originOf(vertices_[i]); });
    std::vector<CubeCell> needed;
    for (const Origin& origin : origins)
    {
      std::copy_if(origin.faces.begin(), origin.faces.end(), std::back_inserter(needed),
        [&](CubeCell face) { return samples_.find(face) == AxisSamples::kNone; });
    }
    samples_.add(context_, complex_, std::move(needed));
    std::vector<AroundCorner<int>> around(count);
    tbb::parallel_for(std::size_t{ 0 }, count,
      [&](std::size_t i) { around[i] = this->samplesOf(origins[i]); });
    for (std::size_t i = 0; i < count; ++i)
    {
      if (around[i].count == 0)
      {
        around[i].add(samples_.addPoint(context_, complex_, this->deepestVoxel(vertices_[i])));
      }
      mesh_.incident.insert(mesh_.incident.end(), around[i].begin(), around[i].end());
      mesh_.cells.push_back(complex_.position(vertices_[i]) - 1);
      mesh_.offsets.push_back(mesh_.incident.size());
      const bool onSheet = origins[i].onSheet;
      onSheet_.push_back(onSheet ? 1 : 0);
      cells.origins.push_back(
        onSheet ? this->originIn(mesh_.cells[i], around[i].values[0]) : kNoVertex);
    }
  }

  /// Returns the vertex of the selection's samples in a grid cell next to one of them.
  std::size_t originIn(const glm::ivec3& gridCell, int sample) const
  {
    const DualSubmesh& part = selected_.sheets.part;
    const auto& corners = part.mesh.corners[selected_.indices[static_cast<std::size_t>(sample)]];
    const auto* const corner = std::find_if(corners.begin(), corners.end(),
      [&](std::uint32_t vertex) { return part.mesh.cells[vertex] == gridCell; });
    return corner == corners.end() ? kNoVertex : part.origins[*corner];
  }

  void placePoints(Representation representation, ThinnedAxis& cells) const
  {
    BisectorPoints& points = cells.points;
    if (representation == Representation::Faces)
    {
      points = cellCentres(context_.geometry, mesh_, samples_.points());
      return;
    }
    points = surfacePoints(context_.geometry, mesh_, samples_.points(), selected_.sheets.cells,
      cells.origins);
    const std::vector<std::uint32_t> order = tileOrder(context_.geometry.part, vertices_.size(),
      [&](std::size_t i) { return mesh_.cells[i]; });
    inBlocks(context_.geometry, order.size(),
      [&](std::size_t begin, std::size_t end)
      { this->settle(order.data() + begin, end - begin, points.points); });
  }

  /// Moves points of surfacePoints() into their grid cells, and to the mean of their samples where
  /// these form no sheet.
  /// @param which points.
  void settle(const std::uint32_t* which, std::size_t count,
    std::vector<BisectorPoint>& points) const
  {
    std::vector<std::size_t> moved;
    std::vector<SiteQuery::Question> answers;
    for (std::size_t k = 0; k < count; ++k)
    {
      const std::size_t i = which[k];
      const glm::dvec3 x = this->clamped(i,
        onSheet_[i] != 0 ? points[i].position : meanCrossing(mesh_, samples_.points(), i));
      if (x != points[i].position)
      {
        moved.push_back(i);
        answers.push_back({ x, closestPoint(context_.geometry.sites, points[i].a.site, x) });
      }
    }
    context_.geometry.query.closest(answers);
    const std::vector<BisectorPoint> found = closestPairs(context_.geometry, mesh_,
      samples_.points(), moved, answers, EqualAngles::FirstBisector);
    for (std::size_t k = 0; k < moved.size(); ++k)
    {
      points[moved[k]] = found[k];
    }
  }

  Origin originOf(CubeCell vertex) const
  {
    Origin origin;
    origin.onSheet = isOnSheet(complex_, samples_, vertex);
    for (const CubeCell face : facesAround(complex_, vertex))
    {
      const bool there = complex_.has(face);
      const bool selected = samples_.find(face) != AxisSamples::kNone;
      if (origin.onSheet ? there && selected : there || selected)
      {
        origin.faces.add(face);
      }
    }
    return origin.faces.count > 0 ? origin : this->anyOrigin(vertex);
  }

  /// Returns the faces around a corner whose grid edges are in the solid.
  Origin anyOrigin(CubeCell vertex) const
  {
    Origin wide;
    wide.widestOnly = true;
    for (const CubeCell face : facesAround(complex_, vertex))
    {
      Crossing edge = dualEdge(complex_, face);
      const bool begins = inSolid(depth_, complex_, edge.voxel);
      ++edge.voxel[edge.axis];
      if (begins && inSolid(depth_, complex_, edge.voxel))
      {
        wide.faces.add(face);
      }
    }
    return wide;
  }

  AroundCorner<int> samplesOf(const Origin& origin) const
  {
    AroundCorner<int> around;
    std::array<double, 12> angles{};
    for (const CubeCell face : origin.faces)
    {
      const int sample = samples_.find(face);
      angles[around.count] = origin.widestOnly ? samples_.point(sample).separationAngle() : 0.0;
      around.add(sample);
    }
    const double limit =
      kWideShare * *std::max_element(angles.begin(), angles.begin() + std::max(1, around.count));
    AroundCorner<int> wide;
    for (int i = 0; i < around.count; ++i)
    {
      if (angles[i] >= limit)
      {
        wide.add(around.values[i]);
      }
    }
    return wide;
  }

  glm::ivec3 deepestVoxel(CubeCell vertex) const
  {
    glm::ivec3 deepest(-1);
    float maxDepth = 0.0f;
    for (const glm::ivec3& voxel : voxelsAround(complex_, vertex))
    {
      const float depth = depth_.at(CubicalComplex::index(complex_.cell(voxel, 0)));
      if (inSolid(depth_, complex_, voxel) && (deepest.x < 0 || depth > maxDepth))
      {
        maxDepth = depth;
        deepest = voxel;
      }
    }
    return deepest;
  }

  glm::dvec3 clamped(std::size_t i, const glm::dvec3& x) const
  {
    const glm::dvec3 low(mesh_.cells[i]);
    return glm::clamp(x, context_.geometry.frame.sample(low) + kCellMargin,
      context_.geometry.frame.sample(low + 1.0) - kCellMargin);
  }

  const CubicalComplex& complex_;
  const DepthField& depth_;
  const SampleContext& context_;
  const SelectedSamples& selected_;
  AxisSamples& samples_;
  std::vector<CubeCell> vertices_; ///< ascending
  DualMesh mesh_;                  ///< cells and samples of the vertices
  std::vector<char> onSheet_;
};

/// Adds a cell unless one of its corners has no point.
template <std::size_t Count>
void addCell(const CellRanks& points, const std::array<CubeCell, Count>& corners,
  std::vector<std::array<std::int64_t, Count>>& cells)
{
  std::array<std::int64_t, Count> cell{};
  for (std::size_t i = 0; i < Count; ++i)
  {
    const std::size_t point = points.find(corners[i]);
    if (point == CellRanks::kNone)
    {
      return;
    }
    cell[i] = static_cast<std::int64_t>(point);
  }
  cells.push_back(cell);
}

/// The cells of an axis that some corners of a complex are the lowest of.
struct CellsAt
{
  std::vector<std::array<std::int64_t, 4>> quads;
  std::vector<std::array<std::int64_t, 2>> lines;
  std::vector<std::int64_t> vertices;
};

/// @param points of the corners.
void addCellsAt(const CubicalComplex& complex, const CellRanks& points, CubeCell vertex,
  CellsAt& cells)
{
  if (complex.maximal(vertex))
  {
    cells.vertices.push_back(static_cast<std::int64_t>(points.find(vertex)));
  }
  for (int along = 0; along < 3; ++along)
  {
    const CubeCell edge = vertex + kEdgeKind + along;
    if (complex.has(edge) && complex.maximal(edge))
    {
      addCell<2>(points, { vertex, vertex + 8 * complex.stride(along) }, cells.lines);
    }
    if (complex.has(vertex + kFaceKind + along))
    {
      const CubeCell u = 8 * complex.stride((along + 1) % 3);
      const CubeCell v = 8 * complex.stride((along + 2) % 3);
      addCell<4>(points, { vertex, vertex + u, vertex + u + v, vertex + v }, cells.quads);
    }
  }
}

} // namespace

bool isOnSheet(const CubicalComplex& complex, const AxisSamples& samples, CubeCell vertex)
{
  const std::array<CubeCell, 12> faces = facesAround(complex, vertex);
  return std::any_of(faces.begin(), faces.end(),
    [&](CubeCell face) { return complex.has(face) && samples.find(face) != AxisSamples::kNone; });
}

ThinnedAxis pointsOfCorners(const CubicalComplex& complex, std::vector<CubeCell> vertices,
  const DepthField& depth, const SampleContext& context, const SelectedSamples& selected,
  Representation representation, AxisSamples& samples)
{
  return CornerPlacer(complex, std::move(vertices), depth, context, selected, samples)
    .place(representation);
}

void addCells(const CubicalComplex& complex, const std::vector<CubeCell>& vertices,
  ThinnedAxis& axis)
{
  constexpr std::size_t kTogether = 4096;
  CellRanks ranks(complex);
  ranks.set(vertices, [](CubeCell vertex) { return vertex; });
  std::vector<CellsAt> parts((vertices.size() + kTogether - 1) / kTogether);
  tbb::parallel_for(std::size_t{ 0 }, parts.size(),
    [&](std::size_t part)
    {
      const std::size_t end = std::min(vertices.size(), (part + 1) * kTogether);
      for (std::size_t i = part * kTogether; i < end; ++i)
      {
        addCellsAt(complex, ranks, vertices[i], parts[part]);
      }
    });
  for (const CellsAt& part : parts)
  {
    axis.vertices.insert(axis.vertices.end(), part.vertices.begin(), part.vertices.end());
    axis.lines.insert(axis.lines.end(), part.lines.begin(), part.lines.end());
    axis.quads.insert(axis.quads.end(), part.quads.begin(), part.quads.end());
  }
}

ThinnedAxis thinnedAxis(const CubicalComplex& complex, const DepthField& depth,
  const SampleContext& context, const SelectedSamples& selected, Representation representation,
  AxisSamples& samples)
{
  const std::vector<CubeCell> vertices = cellsOf(complex, kVertexKind);
  ThinnedAxis axis =
    pointsOfCorners(complex, vertices, depth, context, selected, representation, samples);
  addCells(complex, vertices, axis);
  return axis;
}

} // namespace medial
