#include "base/range_check.h"
#include "base/run.h"
#include "base/stopwatch.h"
#include "medial/error.h"
#include "medial/proximity.h"
#include "mesh/cell_check.h"
#include "proximity/moving_mesh.h"
#include "proximity/pair_proximity.h"
#include "proximity/solid_query.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

namespace medial
{
namespace
{

void requireValid(const ProximityOptions& options)
{
  if (options.maxContacts < 0)
  {
    throwOutside("maximum number of contacts", options.maxContacts, "[0, infinity)");
  }
  if (!(options.maxSeparation >= 0.0))
  {
    throwOutside("maximum separation", options.maxSeparation, "[0, infinity]");
  }
  if (!(options.depthTolerance > 0.0 && options.depthTolerance < 1.0))
  {
    throwOutside("depth tolerance", options.depthTolerance, "(0, 1)");
  }
}

void clear(Proximity& result)
{
  const int a = result.meshA;
  const int b = result.meshB;
  // Lists keep their memory.
  std::vector<PointDepth> depthsOfA = std::move(result.depthsOfA);
  std::vector<PointDepth> depthsOfB = std::move(result.depthsOfB);
  std::vector<ProximityContact> contacts = std::move(result.contacts);
  result = {};
  result.meshA = a;
  result.meshB = b;
  depthsOfA.clear();
  depthsOfB.clear();
  contacts.clear();
  result.depthsOfA = std::move(depthsOfA);
  result.depthsOfB = std::move(depthsOfB);
  result.contacts = std::move(contacts);
}

/// Whether a mesh is computed as the first of two. This depends on nothing but the meshes, so the
/// order in which the caller has them does not show in the result.
bool comesFirst(const TriangleMesh& a, const TriangleMesh& b)
{
  const auto sizes = [](const TriangleMesh& mesh)
  {
    return std::tuple(mesh.triangles.size(), mesh.segments.size(), mesh.vertices.size(),
      mesh.points.size());
  };
  if (sizes(a) != sizes(b))
  {
    return sizes(a) < sizes(b);
  }
  return std::tie(a.points, a.triangles, a.segments, a.vertices) <
    std::tie(b.points, b.triangles, b.segments, b.vertices);
}

void negate(Point3& vector)
{
  for (double& x : vector)
  {
    x = -x;
  }
}

/// Turns the answer for A and B into that for B and A.
void swapMeshes(Proximity& result)
{
  std::swap(result.witnessA, result.witnessB);
  std::swap(result.cellA, result.cellB);
  std::swap(result.depthsOfA, result.depthsOfB);
  negate(result.separatingTranslation);
  for (ProximityContact& contact : result.contacts)
  {
    negate(contact.normal);
    std::swap(contact.cellA, contact.cellB);
  }
}

struct Body
{
  explicit Body(TriangleMesh shape)
    : mesh(std::move(shape))
    , solid(mesh)
  {
  }

  MovingMesh mesh;
  SolidQuery solid;
  bool moved = true;
  double refitSeconds = 0.0; ///< in this frame
};

/// Brings what depends on positions up to date.
void refit(const std::vector<std::unique_ptr<Body>>& bodies, const Run& run)
{
  run.onThreads(
    [&]
    {
      tbb::parallel_for(std::size_t{ 0 }, bodies.size(),
        [&](std::size_t i)
        {
          Body& body = *bodies[i];
          body.refitSeconds = 0.0;
          if (body.moved)
          {
            const Stopwatch stopwatch(body.refitSeconds);
            body.mesh.refit();
            body.solid.update();
            body.moved = false;
          }
        });
    });
}

} // namespace

struct ProximitySolver::State
{
  /// The same pair in either order.
  struct Pair
  {
    std::array<std::unique_ptr<PairProximity>, 2> computed;
  };

  std::vector<std::unique_ptr<Body>> bodies;
  std::vector<Pair> pairs;
  std::vector<Proximity> results;
};

ProximitySolver::ProximitySolver(std::vector<TriangleMesh> meshes)
  : state_(std::make_unique<State>())
{
  if (meshes.size() < 2)
  {
    throw Error(ErrorCode::InvalidInput,
      "proximity needs two meshes or more; there are " + std::to_string(meshes.size()));
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    try
    {
      requireCells(meshes[i]);
      for (std::size_t point = 0; point < meshes[i].points.size(); ++point)
      {
        requireUsable(point, meshes[i].points[point]);
      }
      state_->bodies.push_back(std::make_unique<Body>(std::move(meshes[i])));
    }
    catch (const Error& error)
    {
      throw Error(error.code(), "mesh " + std::to_string(i) + ": " + error.what());
    }
  }
  const int count = this->meshCount();
  for (int a = 0; a < count; ++a)
  {
    for (int b = a + 1; b < count; ++b)
    {
      state_->results.emplace_back();
      state_->results.back().meshA = a;
      state_->results.back().meshB = b;
    }
  }
  state_->pairs.resize(state_->results.size());
}

ProximitySolver::~ProximitySolver() = default;
ProximitySolver::ProximitySolver(ProximitySolver&& other) noexcept = default;
ProximitySolver& ProximitySolver::operator=(ProximitySolver&& other) noexcept = default;

int ProximitySolver::meshCount() const
{
  return static_cast<int>(state_->bodies.size());
}

const TriangleMesh& ProximitySolver::mesh(int i) const
{
  return state_->bodies.at(i)->mesh.mesh();
}

void ProximitySolver::setPoints(int mesh, const std::vector<Point3>& points)
{
  if (mesh < 0 || mesh >= this->meshCount())
  {
    throw Error(ErrorCode::InvalidInput,
      "there is no mesh " + std::to_string(mesh) + " of " + std::to_string(this->meshCount()));
  }
  Body& body = *state_->bodies[mesh];
  const std::size_t count = body.mesh.mesh().points.size();
  if (points.size() != count)
  {
    throw Error(ErrorCode::InvalidInput,
      "mesh " + std::to_string(mesh) + " has " + std::to_string(count) + " points, not " +
        std::to_string(points.size()));
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    requireUsable(i, points[i]);
  }
  body.mesh.setPoints(points);
  body.moved = true;
}

const std::vector<Proximity>& ProximitySolver::compute(const ProximityOptions& options)
{
  requireValid(options);
  const Run run(options.execution);
  refit(state_->bodies, run);
  for (std::size_t i = 0; i < state_->pairs.size(); ++i)
  {
    run.report(static_cast<double>(i) / static_cast<double>(state_->pairs.size()), "proximity");
    Proximity& result = state_->results[i];
    clear(result);
    const Stopwatch stopwatch(result.seconds);
    const Body* first = state_->bodies[result.meshA].get();
    const Body* second = state_->bodies[result.meshB].get();
    result.seconds = std::max(first->refitSeconds, second->refitSeconds); // side by side
    const Box& box = first->mesh.tree().box();
    if (std::sqrt(box.squaredDistance(second->mesh.tree().box())) > options.maxSeparation)
    {
      result.separation = std::numeric_limits<double>::infinity();
      continue;
    }
    const bool swapped = comesFirst(second->mesh.mesh(), first->mesh.mesh());
    if (swapped)
    {
      std::swap(first, second);
    }
    std::unique_ptr<PairProximity>& pair = state_->pairs[i].computed[swapped ? 1 : 0];
    if (pair == nullptr)
    {
      pair =
        std::make_unique<PairProximity>(first->mesh, second->mesh, first->solid, second->solid);
    }
    run.onThreads([&] { pair->compute(options, result); });
    if (swapped)
    {
      swapMeshes(result);
    }
  }
  run.report(1.0, "proximity");
  return state_->results;
}

Proximity computeProximity(const TriangleMesh& a, const TriangleMesh& b,
  const ProximityOptions& options)
{
  ProximitySolver solver({ a, b });
  return solver.compute(options).front();
}

} // namespace medial
