#include "medial/medial/topology/thinned_complex.h"

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
  bool widestOnly = false;
};

class ThinnedComplex
{
public:
  ThinnedComplex(const CellLattice& lattice, const DepthField& depth, const SampleContext& context,
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

  MedialComplex build(Representation representation)
  {
    MedialComplex complex;
    this->addCells(complex);
    this->placePoints(complex);
    this->clampPoints(representation, complex);
    return complex;
  }

private:
  void addCells(MedialComplex& complex) const
  {
    for (const Cell vertex : vertices_)
    {
      if (lattice_.maximal(vertex))
      {
        complex.vertices.push_back(this->point(vertex));
      }
      for (int axis = 0; axis < 3; ++axis)
      {
        const Cell edge = vertex + kEdgeKind + axis;
        if (lattice_.has(edge) && lattice_.maximal(edge))
        {
          complex.lines.push_back(
            { this->point(vertex), this->point(vertex + 8 * lattice_.stride(axis)) });
        }
        if (lattice_.has(vertex + kFaceKind + axis))
        {
          const Cell u = 8 * lattice_.stride((axis + 1) % 3);
          const Cell v = 8 * lattice_.stride((axis + 2) % 3);
          complex.quads.push_back({ this->point(vertex), this->point(vertex + u),
            this->point(vertex + u + v), this->point(vertex + v) });
        }
      }
    }
  }

  std::int64_t point(Cell vertex) const
  {
    return std::lower_bound(vertices_.begin(), vertices_.end(), vertex) - vertices_.begin();
  }

  void placePoints(MedialComplex& complex)
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
      const std::vector<int> around = this->samplesOf(vertices_[i], origins[i]);
      glm::dvec3 sum(0.0);
      for (const int sample : around)
      {
        sum += samples_.point(sample);
        complex.incident.push_back(static_cast<std::size_t>(sample));
      }
      complex.offsets.push_back(complex.incident.size());
      complex.points.push_back(sum / static_cast<double>(around.size()));
    }
  }

  Origin originOf(Cell vertex) const
  {
    Origin both;
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
      angles.push_back(origin.widestOnly ? samples_.angle(context_.sites, around.back()) : 0.0);
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

  void clampPoints(Representation representation, MedialComplex& complex) const
  {
    for (std::size_t i = 0; i < vertices_.size(); ++i)
    {
      const glm::dvec3 high(lattice_.position(vertices_[i]));
      const glm::dvec3 least = context_.frame.sample(high - 1.0) + kCellMargin;
      const glm::dvec3 most = context_.frame.sample(high) - kCellMargin;
      complex.points[i] = representation == Representation::Faces
        ? 0.5 * (least + most)
        : glm::clamp(complex.points[i], least, most);
    }
  }

  const CellLattice& lattice_;
  const DepthField& depth_;
  const SampleContext& context_;
  AxisSamples& samples_;
  std::vector<Cell> vertices_; ///< ascending
};

} // namespace

MedialComplex thinnedComplex(const CellLattice& lattice, const DepthField& depth,
  const SampleContext& context, Representation representation, AxisSamples& samples)
{
  return ThinnedComplex(lattice, depth, context, samples).build(representation);
}

} // namespace medial
