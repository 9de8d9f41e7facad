#pragma once

#include "axis/axis_geometry.h"
#include "axis/side_check.h"
#include "base/checkpoint.h"
#include "field/array_sink.h"
#include "field/engines/make_engine.h"
#include "field/field_pipeline.h"
#include "field/mesh_state.h"
#include "support/engines.h"

#include <glm/glm.hpp>

#include <vector>

namespace medial::test
{

/// The grid edges that the axis of a solid crosses, and what finds its points there.
class MeshCrossings
{
public:
  /// @param angle minimum separation angle, degrees.
  MeshCrossings(const TriangleMesh& mesh, const Grid& grid, double angle)
    : mesh_(mesh)
    , connectivity_(analyseConnectivity(mesh))
    , grid_(grid)
    , run_(Execution())
    , checkpoint_(run_, 0.0, "test")
    , pipeline_(mesh_, connectivity_, grid_, grid_.wholeExtent(), {}, state_.orienter, run_)
    , side_([this] { return pipeline_.insideQuery(); })
    , angle_(angle)
  {
    ArraySink sink(grid_.wholeExtent(), {});
    crossings_ = pipeline_.run(obtainEngine(byEngine(Engine::Processor), state_.engine), sink,
      { angle, Side::Interior });
  }

  const Grid& grid() const { return grid_; }
  const GridFrame& frame() const { return pipeline_.frame(); }
  const std::vector<Crossing>& crossings() const { return crossings_; }
  /// Refers to this.
  AxisGeometry geometry() const
  {
    return { pipeline_.sites(), pipeline_.query(), pipeline_.frame(), grid_.wholeExtent(),
      grid_.wholeExtent(), { glm::radians(angle_) }, checkpoint_, &side_ };
  }
  double exactDistance(const glm::dvec3& x) const
  {
    return glm::distance(pipeline_.query().closest(x).point, x);
  }

private:
  TriangleMesh mesh_;
  MeshConnectivity connectivity_;
  Grid grid_;
  Run run_;
  Checkpoint checkpoint_;
  MeshState state_;
  FieldPipeline pipeline_;
  SideCheck side_;
  double angle_;
  std::vector<Crossing> crossings_;
};

} // namespace medial::test
