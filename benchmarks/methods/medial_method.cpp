#include "methods/field_method.h"

#include "base/stopwatch.h"
#include "medial/compute_distance_field.h"

#include <utility>

namespace medial::benchmark
{
namespace
{

/// A triangle that holds a site, -1 for sites of no triangle.
int triangleOfSite(std::int32_t site, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
{
  const auto faces = static_cast<std::int32_t>(mesh.triangles.size());
  const auto edges = static_cast<std::int32_t>(connectivity.edges.size());
  if (site < faces)
  {
    return site;
  }
  const auto firstOfEdge = [&](int edge)
  {
    return connectivity.edgeTriangles.size(edge) > 0 ? *connectivity.edgeTriangles.begin(edge) : -1;
  };
  if (site < faces + edges)
  {
    return firstOfEdge(site - faces);
  }
  const int point = site - faces - edges;
  return connectivity.pointEdges.size(point) > 0
    ? firstOfEdge(*connectivity.pointEdges.begin(point))
    : -1;
}

class MedialMethod final : public FieldMethod
{
public:
  explicit MedialMethod(Engine engine)
    : engine_(engine)
  {
  }

  std::string name() const override
  {
    return engine_ == Engine::Rasteriser ? "Medial, rasteriser" : "Medial";
  }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    FieldResult result;
    std::vector<std::int32_t> sites;
    MeshConnectivity connectivity;
    RunStatistics statistics;
    double total = 0.0;
    double connectivitySeconds = 0.0;
    timed(total,
      [&]
      {
        connectivity = timed(connectivitySeconds, [&] { return analyseConnectivity(mesh); });
        const auto count = static_cast<std::size_t>(grid.pointCount());
        result.distance.resize(count);
        sites.resize(count);
        FieldArrays arrays;
        arrays.distance = result.distance.data();
        arrays.closestSite = sites.data();
        DistanceFieldOptions options;
        options.sign = SignMethod::None;
        options.engine = engine_;
        statistics =
          computeDistanceField(mesh, connectivity, grid, grid.wholeExtent(), arrays, options);
      });
    this->report(statistics, connectivitySeconds, total, result);
    // Sites are the finer labels, and what users ask for; triangles only serve the comparison.
    result.triangle = nameTriangles(std::move(sites), mesh, connectivity);
    return result;
  }

private:
  static void report(const RunStatistics& statistics, double connectivity, double total,
    FieldResult& result)
  {
    const RunStatistics::Seconds& s = statistics.seconds;
    result.seconds = { { "topology", connectivity }, { "sites", s.sites }, { "cull", s.cull },
      { "polygons", s.polygons }, { "draw", s.draw }, { "resolve", s.resolve } };
    double known = 0.0;
    for (const auto& phase : result.seconds)
    {
      known += phase.second;
    }
    // Less than zero where phases ran side by side.
    result.seconds.emplace_back("other", total - known);
    const bool drawn = statistics.engine == Engine::Rasteriser;
    result.figures = { { drawn ? "fragments_per_voxel" : "evaluations_per_voxel",
                         statistics.fragmentsPerVoxel() },
      { "candidate_pairs", static_cast<double>(statistics.candidatePairs) },
      { "polygons", static_cast<double>(statistics.polygons) } };
  }

  /// In place, so that the peak of memory is that of the field.
  static std::vector<std::int32_t> nameTriangles(std::vector<std::int32_t> labels,
    const TriangleMesh& mesh, const MeshConnectivity& connectivity)
  {
    for (std::int32_t& label : labels)
    {
      label = label < 0 ? -1 : triangleOfSite(label, mesh, connectivity);
    }
    return labels;
  }

  Engine engine_;
};

} // namespace

std::unique_ptr<FieldMethod> makeMedialMethod(Engine engine)
{
  return std::make_unique<MedialMethod>(engine);
}

} // namespace medial::benchmark
