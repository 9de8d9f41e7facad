#include "medial/medial_solver.h"

#include "field/array_sink.h"
#include "medial/error.h"
#include "pipeline/frame_stages.h"

#include <string>
#include <utility>

namespace medial
{

struct MedialSolver::State
{
  TriangleMesh mesh;
  MeshConnectivity connectivity;
  MeshState kept;
};

MedialSolver::MedialSolver(TriangleMesh mesh)
  : state_(std::make_unique<State>())
{
  state_->connectivity = analyseConnectivity(mesh);
  state_->mesh = std::move(mesh);
}

MedialSolver::~MedialSolver() = default;
MedialSolver::MedialSolver(MedialSolver&& other) noexcept = default;
MedialSolver& MedialSolver::operator=(MedialSolver&& other) noexcept = default;

const TriangleMesh& MedialSolver::mesh() const
{
  return state_->mesh;
}

const MeshConnectivity& MedialSolver::connectivity() const
{
  return state_->connectivity;
}

void MedialSolver::setPoints(std::vector<Point3> points)
{
  if (points.size() != state_->mesh.points.size())
  {
    throw Error(ErrorCode::InvalidInput,
      std::to_string(points.size()) + " points given for a mesh of " +
        std::to_string(state_->mesh.points.size()));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    requireUsable(i, points[i]);
  }
  state_->mesh.points = std::move(points);
  state_->connectivity.signedVolume = signedVolume(state_->mesh);
}

RunStatistics MedialSolver::computeField(const Grid& grid, const Extent& extent, FieldSink& sink,
  const DistanceFieldOptions& options)
{
  return medial::computeField(state_->mesh, state_->connectivity, grid, extent, sink, options,
    state_->kept);
}

RunStatistics MedialSolver::computeField(const Grid& grid, const Extent& extent,
  const FieldArrays& arrays, const DistanceFieldOptions& options)
{
  ArraySink sink(extent, arrays);
  return this->computeField(grid, extent, sink, options);
}

MedialAxis MedialSolver::computeAxis(const Grid& grid, const MedialAxisOptions& options,
  const FieldArrays& arrays)
{
  ArraySink sink(grid.wholeExtent(), arrays);
  return medial::computeAxis(state_->mesh, state_->connectivity, grid, options, sink, state_->kept);
}

} // namespace medial
