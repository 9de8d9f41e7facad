#include "sign/surface_orientation.h"

#include "base/vectors.h"
#include "sign/containment.h"
#include "sign/patch_measure.h"
#include "sign/patches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

namespace medial
{
namespace
{

using Points = std::vector<glm::dvec3>;

/// Copies the points of a mesh, relative to its middle.
void pointsAroundMiddle(const TriangleMesh& mesh, Points& points)
{
  const Bounds bounds = mesh.bounds();
  points.clear();
  points.reserve(mesh.points.size());
  for (const Point3& p : mesh.points)
  {
    glm::dvec3 relative;
    for (int axis = 0; axis < 3; ++axis)
    {
      relative[axis] = p[axis] - (0.5 * bounds.min[axis] + 0.5 * bounds.max[axis]);
    }
    points.push_back(relative);
  }
}

void addRimEdge(const MeshConnectivity& connectivity, int edge, int net, std::vector<RimEdge>& rim)
{
  const auto [from, to] = connectivity.edges[edge];
  if (net != 0)
  {
    rim.push_back(net > 0 ? RimEdge{ from, to, net } : RimEdge{ to, from, -net });
  }
}

/// What is known of a patch as the surface of a solid.
struct PatchSolid
{
  std::vector<RimEdge> rim;
  std::vector<WeightedTriangle> lids;
  double volume = 0.0; ///< within the patch and its lids; negative if it faces inwards
  bool solid = false;  ///< whether it encloses a volume up to small holes
  bool turned = false;
};

} // namespace

/// A mesh whose points are those of the last call.
class SurfaceOrienter::Surface
{
public:
  Surface(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
    : patches_(findPatches(mesh, connectivity))
    , agreeing_(std::all_of(patches_.senses.begin(), patches_.senses.end(),
        [](std::int8_t sense) { return sense > 0; }))
  {
  }

  const SurfaceOrientation& orient(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
  {
    mesh_ = &mesh;
    connectivity_ = &connectivity;
    points_.clear();
    const bool same = this->directPatches();
    this->turnPatches();
    if (!same || !this->areTurnedAsBefore())
    {
      result_ = this->result();
    }
    return result_;
  }

private:
  /// Gives every patch the direction of most of its area.
  /// @return whether all of them had it before.
  bool directPatches()
  {
    if (agreeing_ && backwards_)
    {
      return true;
    }
    pointsAroundMiddle(*mesh_, points_);
    std::vector<bool> backwards = runningBackwards(patches_, *mesh_, points_);
    if (backwards_ == backwards)
    {
      return true;
    }
    senses_ = patches_.senses;
    for (std::size_t patch = 0; patch < backwards.size(); ++patch)
    {
      for (const int t : patches_.triangles[patch])
      {
        senses_[t] = static_cast<std::int8_t>(backwards[patch] ? -senses_[t] : senses_[t]);
      }
    }
    backwards_ = std::move(backwards);
    solids_.assign(patches_.triangles.size(), {});
    this->findRims();
    for (PatchSolid& solid : solids_)
    {
      solid.lids = lidsOf(solid.rim);
    }
    return false;
  }

  /// Whether the same patches are turned as before the last turnPatches().
  bool areTurnedAsBefore() const
  {
    return std::equal(solids_.begin(), solids_.end(), turnedBefore_.begin(), turnedBefore_.end(),
      [](const PatchSolid& solid, bool before) { return solid.turned == before; });
  }

  SurfaceOrientation result() const
  {
    SurfaceOrientation result;
    for (std::size_t t = 0; t < mesh_->triangles.size(); ++t)
    {
      const int original = patches_.originals[t];
      const bool isCopy = original != static_cast<int>(t);
      const int turn = solids_[patches_.ofTriangle[original]].turned ? -1 : 1;
      const int direction = turn * senses_[original] * (isCopy ? this->alike(t, original) : 1);
      result.directions.push_back(static_cast<std::int8_t>(direction));
      result.weights.push_back(static_cast<std::int8_t>(isCopy ? 0 : direction));
      result.copies += isCopy ? 1 : 0;
      result.turned += !isCopy && direction < 0 ? 1 : 0;
    }
    for (int edge = 0; edge < connectivity_->edgeTriangles.rows(); ++edge)
    {
      int net = 0;
      std::for_each(connectivity_->edgeTriangles.begin(edge),
        connectivity_->edgeTriangles.end(edge),
        [&](int t) { net += result.weights[t] * directionAlong(*mesh_, *connectivity_, t, edge); });
      addRimEdge(*connectivity_, edge, net, result.rim);
    }
    return result;
  }

  /// Returns 1 if two triangles with the same corners face the same way, otherwise -1.
  int alike(std::size_t a, int b) const
  {
    const int edge = connectivity_->triangleEdges[b][0];
    return directionAlong(*mesh_, *connectivity_, static_cast<int>(a), edge) *
      directionAlong(*mesh_, *connectivity_, b, edge);
  }

  /// Finds the rim of every patch, whatever other patches do there.
  void findRims()
  {
    std::vector<std::pair<int, int>> nets; // patch and direction
    for (int edge = 0; edge < connectivity_->edgeTriangles.rows(); ++edge)
    {
      nets.clear();
      std::for_each(connectivity_->edgeTriangles.begin(edge),
        connectivity_->edgeTriangles.end(edge),
        [&](int t)
        {
          nets.emplace_back(patches_.ofTriangle[t],
            senses_[t] * directionAlong(*mesh_, *connectivity_, t, edge));
        });
      std::sort(nets.begin(), nets.end());
      for (auto first = nets.begin(); first != nets.end();)
      {
        const int patch = first->first;
        int net = 0;
        for (; first != nets.end() && first->first == patch; ++first)
        {
          net += first->second;
        }
        if (patch >= 0)
        {
          addRimEdge(*connectivity_, edge, net, solids_[patch].rim);
        }
      }
    }
  }

  /// Calls visit() with every triangle of a patch and its lids, whether it is of a lid.
  template <typename Visit>
  void visitTriangles(int patch, const Visit& visit) const
  {
    for (const int t : patches_.triangles[patch])
    {
      const auto& [a, b, c] = mesh_->triangles[t];
      visit(CountedTriangle{ { points_[a], points_[b], points_[c] }, senses_[t] }, false);
    }
    for (const WeightedTriangle& lid : solids_[patch].lids)
    {
      const auto& [a, b, c] = lid.corners;
      visit(CountedTriangle{ { points_[a], points_[b], points_[c] }, lid.weight }, true);
    }
  }

  /// Whether a patch and its lids face inwards, where that is more than a matter of rounding.
  bool facesInwards(int patch) const
  {
    const auto pointAt = [this](int point) { return toVector(mesh_->points[point]); };
    const glm::dvec3 origin = pointAt(mesh_->triangles[patches_.triangles[patch].front()][0]);
    double volume = 0.0;
    const auto add = [&](const std::array<int, 3>& corners, int weight)
    {
      const glm::dvec3 a = pointAt(corners[0]) - origin;
      const glm::dvec3 b = pointAt(corners[1]) - origin;
      const glm::dvec3 c = pointAt(corners[2]) - origin;
      volume += weight * glm::dot(a, glm::cross(b - a, c - a));
    };
    for (const int t : patches_.triangles[patch])
    {
      add(mesh_->triangles[t], senses_[t]);
    }
    for (const WeightedTriangle& lid : solids_[patch].lids)
    {
      add(lid.corners, lid.weight);
    }
    return volume < 0.0;
  }

  void measure(int patch)
  {
    PatchSolid& solid = solids_[patch];
    const glm::dvec3 origin = points_[mesh_->triangles[patches_.triangles[patch].front()][0]];
    PatchMeasure sum;
    this->visitTriangles(patch,
      [&](const CountedTriangle& triangle, bool isLid) { sum.add(triangle, origin, isLid); });
    solid.volume = sum.volume;
    solid.solid = sum.isSolid();
  }

  /// Decides which patches turn.
  void turnPatches()
  {
    bool anyInwards = false;
    turnedBefore_.resize(solids_.size());
    std::transform(solids_.begin(), solids_.end(), turnedBefore_.begin(),
      [](const PatchSolid& solid) { return solid.turned; });
    for (std::size_t patch = 0; patch < solids_.size(); ++patch)
    {
      solids_[patch].turned = false;
      anyInwards = anyInwards || this->facesInwards(static_cast<int>(patch));
    }
    if (!anyInwards)
    {
      return; // the usual case: no patch turns, whether it is a solid or not
    }
    if (points_.empty())
    {
      pointsAroundMiddle(*mesh_, points_);
    }
    for (std::size_t patch = 0; patch < solids_.size(); ++patch)
    {
      this->measure(static_cast<int>(patch));
    }
    // Of solids that face alike it does not matter which contains which.
    this->turnSolids(
      this->facingAlike() ? std::vector<int>(solids_.size(), -1) : this->containers());
  }

  /// Whether all solids face outwards, or all inwards.
  bool facingAlike() const
  {
    const auto faces = [this](bool inwards)
    {
      return std::any_of(solids_.begin(), solids_.end(),
        [inwards](const PatchSolid& solid)
        { return solid.solid && (solid.volume < 0.0) == inwards; });
    };
    return !(faces(false) && faces(true));
  }

  /// Returns the smallest solid that contains a patch, or -1, for every patch.
  std::vector<int> containers() const
  {
    const auto count = static_cast<int>(solids_.size());
    std::vector<int> result(count, -1);
    if (count < 2)
    {
      return result;
    }
    Points probes;
    std::vector<int> patchOfProbe;
    std::vector<SolidTriangle> triangles;
    for (int patch = 0; patch < count; ++patch)
    {
      this->addProbes(patch, probes, patchOfProbe);
      if (solids_[patch].solid)
      {
        this->visitTriangles(patch,
          [&](const CountedTriangle& triangle, bool /*isLid*/) {
            triangles.push_back({ triangle.corners, patch, triangle.weight });
          });
      }
    }
    const Containment containment(triangles, probes);
    std::vector<std::unordered_map<int, std::size_t>> hits(count);
    for (std::size_t i = 0; i < probes.size(); ++i)
    {
      for (const auto& [solid, winding] : containment.windingsAt(static_cast<int>(i)))
      {
        hits[patchOfProbe[i]][solid] += winding != 0 ? 1 : 0;
      }
    }
    for (int patch = 0; patch < count; ++patch)
    {
      const std::size_t probed = probesOf(patches_.triangles[patch].size());
      for (const auto& [solid, hit] : hits[patch])
      {
        const int smallest = result[patch];
        if (isContained(hit, probed) && this->isSmaller(patch, solid) &&
          (smallest < 0 || this->isSmaller(solid, smallest)))
        {
          result[patch] = solid;
        }
      }
    }
    return result;
  }

  bool isSmaller(int a, int b) const
  {
    const double volumeA = std::abs(solids_[a].volume);
    const double volumeB = std::abs(solids_[b].volume);
    return volumeA != volumeB ? volumeA < volumeB : a < b;
  }

  void addProbes(int patch, Points& probes, std::vector<int>& patchOfProbe) const
  {
    const std::vector<int>& members = patches_.triangles[patch];
    for (std::size_t i = 0; i < probesOf(members.size()); ++i)
    {
      const auto& [a, b, c] = mesh_->triangles[members[probedTriangle(i, members.size())]];
      probes.push_back((points_[a] + points_[b] + points_[c]) / 3.0);
      patchOfProbe.push_back(patch);
    }
  }

  /// Turns solids, the largest first, so that a container is done before what it contains.
  void turnSolids(const std::vector<int>& containers)
  {
    std::vector<int> order(solids_.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [this](int a, int b) { return this->isSmaller(b, a); });
    for (const int patch : order)
    {
      PatchSolid& solid = solids_[patch];
      const int container = containers[patch];
      if (solid.solid)
      {
        solid.turned = container < 0 ? solid.volume < 0.0 : solids_[container].turned;
      }
    }
  }

  const TriangleMesh* mesh_ = nullptr;
  const MeshConnectivity* connectivity_ = nullptr;
  Points points_; ///< empty where they are not needed
  Patches patches_;
  bool agreeing_; ///< whether the triangles of every patch run the same way
  std::optional<std::vector<bool>> backwards_; ///< patches against their direction as found
  std::vector<std::int8_t> senses_;            ///< as Patches::senses, for the patches' directions
  std::vector<PatchSolid> solids_;
  std::vector<bool> turnedBefore_; ///< per patch, at the call before
  SurfaceOrientation result_;
};

SurfaceOrienter::SurfaceOrienter() = default;
SurfaceOrienter::~SurfaceOrienter() = default;

const SurfaceOrientation& SurfaceOrienter::orient(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
{
  if (!surface_)
  {
    surface_ = std::make_unique<Surface>(mesh, connectivity);
  }
  return surface_->orient(mesh, connectivity);
}

SurfaceOrientation orientSurface(const TriangleMesh& mesh, const MeshConnectivity& connectivity)
{
  return SurfaceOrienter().orient(mesh, connectivity);
}

std::optional<OrientedMesh> turned(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const SurfaceOrientation& orientation)
{
  if (std::none_of(orientation.directions.begin(), orientation.directions.end(),
        [](int direction) { return direction < 0; }))
  {
    return {};
  }
  OrientedMesh result{ mesh, connectivity };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (orientation.directions[t] < 0)
    {
      std::swap(result.mesh.triangles[t][1], result.mesh.triangles[t][2]);
      std::swap(result.connectivity.triangleEdges[t][0], result.connectivity.triangleEdges[t][2]);
    }
  }
  return result;
}

} // namespace medial
