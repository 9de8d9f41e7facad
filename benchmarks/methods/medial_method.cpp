#include "methods/field_method.h"

#include "medial/common/stopwatch.h"
#include "medial/distance/distance_field.h"

namespace medial::benchmark
{
namespace
{

/// A triangle that holds a site, -1 for sites of no triangle.
int triangleOfSite(std::int32_t site, const TriangleMesh& mesh, const MeshTopology& topology)
{
  const auto faces = static_cast<std::int32_t>(mesh.triangles.size());
  const auto edges = static_cast<std::int32_t>(topology.edges.size());
  if (site < faces)
  {
    return site;
  }
  const auto firstOfEdge = [&](int edge)
  { return topology.edgeTriangles.size(edge) > 0 ? *topology.edgeTriangles.begin(edge) : -1; };
  if (site < faces + edges)
  {
    return firstOfEdge(site - faces);
  }
  const int point = site - faces - edges;
  return topology.pointEdges.size(point) > 0 ? firstOfEdge(*topology.pointEdges.begin(point)) : -1;
}

class MedialMethod final : public FieldMethod
{
public:
  std::string name() const override { return "Medial"; }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    FieldResult result;
    std::vector<std::int32_t> sites;
    MeshTopology topology;
    RunStatistics statistics;
    double total = 0.0;
    double topologySeconds = 0.0;
    timed(total,
      [&]
      {
        topology = timed(topologySeconds, [&] { return analyseTopology(mesh); });
        const auto count = static_cast<std::size_t>(grid.pointCount());
        result.distance.resize(count);
        sites.resize(count);
        FieldArrays arrays;
        arrays.distance = result.distance.data();
        arrays.closestSite = sites.data();
        DistanceFieldOptions options;
        options.sign = SignMethod::None;
        statistics =
          computeDistanceField(mesh, topology, grid, grid.wholeExtent(), arrays, options);
      });
    this->report(statistics, topologySeconds, total, result);
    // Sites are the finer labels, and what is asked for; triangles only serve the comparison.
    this->nameTriangles(sites, mesh, topology, result);
    return result;
  }

private:
  static void report(const RunStatistics& statistics, double topology, double total,
    FieldResult& result)
  {
    const RunStatistics::Seconds& s = statistics.seconds;
    result.seconds = { { "topology", topology }, { "sites", s.sites }, { "cull", s.cull },
      { "polygons", s.polygons }, { "draw", s.draw }, { "resolve", s.resolve } };
    double known = 0.0;
    for (const auto& phase : result.seconds)
    {
      known += phase.second;
    }
    // Less than zero where phases ran side by side.
    result.seconds.emplace_back("other", total - known);
    result.figures = { { "fragments_per_voxel", statistics.fragmentsPerVoxel() },
      { "candidate_pairs", static_cast<double>(statistics.candidatePairs) },
      { "polygons", static_cast<double>(statistics.polygons) } };
  }

  static void nameTriangles(const std::vector<std::int32_t>& sites, const TriangleMesh& mesh,
    const MeshTopology& topology, FieldResult& result)
  {
    result.triangle.reserve(sites.size());
    for (const std::int32_t site : sites)
    {
      result.triangle.push_back(site < 0 ? -1 : triangleOfSite(site, mesh, topology));
    }
  }
};

} // namespace

std::unique_ptr<FieldMethod> makeMedialMethod()
{
  return std::make_unique<MedialMethod>();
}

} // namespace medial::benchmark
