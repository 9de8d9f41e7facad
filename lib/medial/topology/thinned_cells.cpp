#include "medial/medial/topology/thinned_cells.h"

#include "medial/medial/axis_points.h"
#include "medial/medial/dual_mesh.h"
#include "medial/medial/separation.h"
#include "medial/sites/closest_point.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace medial
{
namespace
{

/// Samples count whose separation angle is at least this part of the widest around a point.
constexpr double kWideShare = 0.5;

/// The faces around a corner: those dual to the edges of its grid cell.
std::array<Cell, 12> facesAround(const CellLattice& lattice, Cell vertex)
{
  std::array<Cell, 12> faces{};
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Cell u = 8 * lattice.stride((axis + 1) % 3);
    const Cell v = 8 * lattice.stride((axis + 2) % 3);
    const Cell face = vertex + kFaceKind + axis;
    for (const Cell step : { Cell{ 0 }, u, v, u + v })
    {
      faces[count++] = face - step;
    }
  }
  return faces;
}

/// Where the point of a corner comes from.
struct Origin
{
  std::vector<Cell> faces;
  bool onSheet = false; ///< faces that are selected and there
  bool widestOnly = false;
};

class CellBuilder
{
public:
  CellBuilder(const CellLattice& lattice, const DepthField& depth, const SampleContext& context,
    AxisSamples& samples)
    : lattice_(lattice)
    , depth_(depth)
    , context_(context)
    , samples_(samples)
  {
    const auto positions = static_cast<Cell>(lattice.positions());
    for (Cell vertex = 0; vertex < 8 * positions; vertex += 8)
    {
      if (lattice.has(vertex))
      {
        vertices_.push_back(vertex);
      }
    }
  }

  ThinnedCells build(Representation representation)
  {
    ThinnedCells cells;
    this->addCells(cells);
    this->findSamples();
    this->placePoints(representation, cells.points);
    return cells;
  }

private:
  void addCells(ThinnedCells& cells) const
  {
    for (const Cell vertex : vertices_)
    {
      if (lattice_.maximal(vertex))
      {
        cells.vertices.push_back(this->point(vertex));
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        const Cell edge = vertex + kEdgeKind + axis;
        if (lattice_.has(edge) && lattice_.maximal(edge))
        {
          cells.lines.push_back(
            { this->point(vertex), this->point(vertex + 8 * lattice_.stride(axis)) });
        }
        if (lattice_.has(vertex + kFaceKind + axis))
        {
          const Cell u = 8 * lattice_.stride((axis + 1) % 3);
          const Cell v = 8 * lattice_.stride((axis + 2) % 3);
          cells.quads.push_back({ this->point(vertex), this->point(vertex + u),
            this->point(vertex + u + v), this->point(vertex + v) });
        }
      }
    }
  }

  std::int64_t point(Cell vertex) const
  {
    return std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin();
  }

  void findSamples()
  {
    std::vector<Origin> origins(vertices_.size());
    tbb::parallel_for(std::size_t{ 0 }, vertices_.size(),
      [&](std::size_t i) { origins[i] = this->originOf(vertices_[i]); });
    std::vector<Cell> needed;
    for (const Origin& origin : origins)
    {
      needed.insert(needed.end(), origin.faces.begin(), origin.faces.end());
    }
    samples_.add(context_, lattice_, std::move(needed));
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
      for (const int sample : this->samplesOf(vertices_[i], origins[i]))
      {
        mesh_.incident.push_back(static_cast<std::size_t>(sample));
      }
      mesh_.cells.push_back(lattice_.position(vertices_[i]) - 1);
      mesh_.offsets.push_back(mesh_.incident.size());
      onSheet_.push_back(origins[i].onSheet ? 1 : 0);
    }
  }

  void placePoints(Representation representation, BisectorPoints& points) const
  {
    if (representation == Representation::Faces)
    {
      points = cellCentres(context_.geometry, mesh_, samples_.points());
      return;
    }
    points = surfacePoints(context_.geometry, mesh_, samples_.points());
    tbb::parallel_for(std::size_t{ 0 }, vertices_.size(),
      [&](std::size_t i)
      {
        BisectorPoint& point = points.points[i];
        const glm::dvec3 wanted = onSheet_[i] != 0 ? point.position : this->meanOf(i);
        const glm::dvec3 x = this->clamped(i, wanted);
        if (x != point.position)
        {
          point = this->contacts(i, x);
        }
      });
  }

  Origin originOf(Cell vertex) const
  {
    Origin both;
    both.onSheet = true;
    Origin either;
    Origin wide;
    wide.widestOnly = true;
    for (const Cell face : facesAround(lattice_, vertex))
    {
      const bool there = lattice_.has(face);
      const bool selected = samples_.find(face) != AxisSamples::kNone;
      if (there && selected)
      {
        both.faces.push_back(face);
      }
      if (there || selected)
      {
        either.faces.push_back(face);
      }
      Crossing edge = dualEdge(lattice_, face);
      const bool begins = inSolid(depth_, lattice_, edge.voxel);
      ++edge.voxel[edge.axis];
      if (begins && inSolid(depth_, lattice_, edge.voxel))
      {
        wide.faces.push_back(face);
      }
    }
    return !both.faces.empty() ? both : (!either.faces.empty() ? either : wide);
  }

  std::vector<int> samplesOf(Cell vertex, const Origin& origin)
  {
    std::vector<int> around;
    std::vector<double> angles;
    for (const Cell face : origin.faces)
    {
      around.push_back(samples_.find(face));
      angles.push_back(origin.widestOnly ? samples_.point(around.back()).separationAngle() : 0.0);
    }
    if (around.empty())
    {
      return { samples_.addPoint(context_, lattice_, this->deepestVoxel(vertex)) };
    }
    const double limit = kWideShare * *std::max_element(angles.begin(), angles.end());
    std::vector<int> wide;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      if (angles[i] >= limit)
      {
        wide.push_back(around[i]);
      }
    }
    return wide;
  }

  glm::ivec3 deepestVoxel(Cell vertex) const
  {
    glm::ivec3 deepest(-1);
    float most = 0.0f;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 voxel =
        lattice_.position(vertex) - glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
      const float depth = depth_.at(CellLattice::index(lattice_.cell(voxel, 0)));
      if (inSolid(depth_, lattice_, voxel) && (deepest.x < 0 || depth > most))
      {
        most = depth;
        deepest = voxel;
      }
    }
    return deepest;
  }

  glm::dvec3 meanOf(std::size_t i) const
  {
    glm::dvec3 sum(0.0);
    for (std::size_t k = mesh_.offsets[i]; k < mesh_.offsets[i + 1]; ++k)
    {
      sum += samples_.points().points[mesh_.incident[k]].position;
    }
    return sum / static_cast<double>(mesh_.offsets[i + 1] - mesh_.offsets[i]);
  }

  glm::dvec3 clamped(std::size_t i, const glm::dvec3& x) const
  {
    const glm::dvec3 low(mesh_.cells[i]);
    return glm::clamp(x, context_.geometry.frame.sample(low) + kCellMargin,
      context_.geometry.frame.sample(low + 1.0) - kCellMargin);
  }

  /// The closest surface point, and of the samples' sites the one seen under the widest angle.
  BisectorPoint contacts(std::size_t i, const glm::dvec3& x) const
  {
    BisectorPoint point;
    point.position = x;
    point.a = context_.geometry.query.closest(x);
    point.b = point.a;
    double widest = -1.0;
    for (std::size_t k = mesh_.offsets[i]; k < mesh_.offsets[i + 1]; ++k)
    {
      const BisectorPoint& sample = samples_.points().points[mesh_.incident[k]];
      for (const int site : { sample.a.site, sample.b.site })
      {
        const SitePoint candidate = closestPoint(context_.geometry.sites, site, x);
        const double angle = separationAngle(x, point.a.point, candidate.point);
        if (angle > widest)
        {
          widest = angle;
          point.b = candidate;
        }
      }
    }
    return point;
  }

  const CellLattice& lattice_;
  const DepthField& depth_;
  const SampleContext& context_;
  AxisSamples& samples_;
  std::vector<Cell> vertices_; ///< ascending
  DualMesh mesh_;              ///< cells and samples of the vertices
  std::vector<char> onSheet_;
};

} // namespace

ThinnedCells thinnedCells(const CellLattice& lattice, const DepthField& depth,
  const SampleContext& context, Representation representation, AxisSamples& samples)
{
  return CellBuilder(lattice, depth, context, samples).build(representation);
}

} // namespace medial
