#pragma once

#include "base/checkpoint.h"
#include "culling/candidate_tiles.h"
#include "culling/tile_query.h"
#include "field/engines/processor/slab_field.h"
#include "field/engines/processor/tile_evaluator.h"
#include "field/engines/rasteriser/slab_renderer.h"
#include "field/field_memory.h"
#include "field/field_writer.h"
#include "medial/distance_field.h"
#include "sites/grid_frame.h"
#include "sites/site_set.h"

#include <functional>
#include <memory>
#include <vector>

namespace medial
{

/// A later stage of the pipeline, which works on slab after slab in ascending z, where the
/// evaluator left it.
class SlabStage
{
public:
  virtual ~SlabStage() = default;

  /// A slab in GPU textures; on the GPU thread.
  /// @param slab its slices are in slots 1 to slab.size(2) of the renderer's atlas.
  /// @param carried whether slot 0 holds the slice below slab.min[2].
  virtual void process(const SlabRenderer& renderer, const Extent& slab, bool carried) = 0;
  /// A slab in host memory, in the pipeline's arena.
  virtual void process(const SlabField& slab, const TileEvaluator& evaluator) = 0;
};

/// Mesh -> sites -> candidate tiles -> closest sites -> resolved field, slab by slab. While the GPU
/// works on a slab, the processor prepares the next one and stores the one before.
class FieldPipeline
{
public:
  /// Checks everything that can be checked before work starts.
  /// @throws Error as computeDistanceField.
  FieldPipeline(const TriangleMesh& mesh, const MeshConnectivity& connectivity, const Grid& grid,
    const Extent& extent, const DistanceFieldOptions& options);

  /// Takes over what an earlier pipeline over the same connectivity left, and leaves as much.
  void useMemory(FieldMemory& memory) { memory_ = &memory; }

  /// @param stage may be null.
  void run(FieldSink& sink, SlabStage* stage);

  /// Exact queries anywhere inside the extent; after a run with a stage.
  const TileQuery& query() const { return *query_; }

  const SiteSet& sites() const { return sites_; }
  const GridFrame& frame() const { return frame_; }
  SignMethod sign() const { return sign_; }
  RunStatistics& statistics() { return statistics_; }

  const Run& execution() const { return run_; }

private:
  using Renderer = gl::OnGpuThread<SlabRenderer>;
  struct Slab;
  struct InFlight;

  void rasterise(FieldSink& sink, SlabStage* stage);
  void evaluate(FieldSink& sink);
  void evaluateForStage(FieldSink& sink, SlabStage& stage);

  FieldSign fieldSign() const;
  SiteSet buildSites();
  static double shareOfField(bool staged) { return staged ? 0.8 : 1.0; }
  int slabSlices(std::size_t bytesPerPoint) const;
  AtlasLayout chooseAtlas(std::size_t bytesPerPoint) const;
  std::vector<Extent> slabsOf(int slices) const;
  FieldWriter makeWriter() const;
  CandidateHierarchy cullBlocks(int slabSlices, TileHull hull);
  void cullSlab(const CandidateHierarchy& hierarchy, Slab& slab, const Checkpoint& checkpoint);

  void clipPolygons(Slab& slab, const AtlasLayout& atlas);
  Renderer& obtainRenderer(const AtlasLayout& atlas);
  void render(SlabRenderer& renderer, Slab& slab, SlabStage* stage);
  void noteSeeds(const Slab& slab);
  void storeSlab(const Slab& slab, FieldWriter& writer, FieldSink& sink);

  TileEvaluator makeEvaluator();
  void evaluateTiles(const TileEvaluator& evaluator, const Slab& slab, const FieldWriter& writer,
    SlabField& field, const Checkpoint& checkpoint);
  void addGpuSeconds();

  const TriangleMesh& mesh_;
  const MeshConnectivity& connectivity_;
  Extent extent_;
  DistanceFieldOptions options_;
  Run run_;
  GridFrame frame_;
  SignMethod sign_;
  RunStatistics statistics_;
  RunStatistics::Seconds gpuSeconds_; ///< of what the GPU thread does
  SiteSet sites_;
  CandidateFilter filter_;
  std::vector<glm::vec4> normals_;
  FieldMemory ownMemory_;
  FieldMemory* memory_ = &ownMemory_;
  ClosestSeeds nextSeeds_;
  std::unique_ptr<TileQuery> query_; ///< only where a stage needs it
};

} // namespace medial
