#include "field/engines/device/device_mesh.h"

#include "culling/group_tree.h"
#include "field/engines/device/element_order.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace medial
{
namespace
{

/// Sizes in the buffers of the kernels, bytes.
constexpr std::int64_t kPointBytes = 3 * sizeof(double);
constexpr std::int64_t kFaceBytes = 4 * sizeof(double);
constexpr std::int64_t kEdgeBytes = 4 * sizeof(std::int32_t);
constexpr std::int64_t kVertexBytes = 2 * sizeof(std::int32_t);
constexpr std::int64_t kElementBytes = 9 * 4 * sizeof(std::uint32_t);
constexpr std::int64_t kDiscBytes = 3 * 4 * sizeof(float);
/// Slots that groups of elements of different sizes may leave empty, more than there can be.
constexpr std::int64_t kPadding = 512;

std::vector<TreeLevel> levelsOver(int groups)
{
  std::vector<TreeLevel> levels{ { 0, groups } };
  while (levels.back().count > 1)
  {
    const TreeLevel& below = levels.back();
    levels.push_back({ below.first + below.count, (below.count + kGroupSize - 1) / kGroupSize });
  }
  return levels;
}

/// A box around points, local units.
struct PointBounds
{
  glm::dvec3 low{ std::numeric_limits<double>::max() };
  glm::dvec3 high{ std::numeric_limits<double>::lowest() };
  double farthest = 0.0; ///< from the local origin
};

PointBounds boundsOf(const TriangleMesh& mesh, const LocalCoordinates& local)
{
  PointBounds bounds;
  double squared = 0.0;
  for (const Point3& point : mesh.points)
  {
    const glm::dvec3 x = local.toLocal(point);
    bounds.low = glm::min(bounds.low, x);
    bounds.high = glm::max(bounds.high, x);
    squared = std::max(squared, glm::dot(x, x));
  }
  bounds.farthest = std::sqrt(squared);
  return bounds;
}

} // namespace

std::int64_t DeviceMesh::largestBuffer(const TriangleMesh& mesh,
  const MeshConnectivity& connectivity)
{
  constexpr std::int64_t kNormalBytes = 4 * sizeof(float);
  const auto count = [](const auto& values) { return static_cast<std::int64_t>(values.size()); };
  const std::int64_t faces = count(mesh.triangles);
  const std::int64_t edges = count(connectivity.edges);
  const std::int64_t vertices = count(mesh.points);
  const std::int64_t elements = faces + count(mesh.segments) + count(mesh.vertices) + kPadding;
  const std::int64_t numbers = 6 * faces + 2 * edges + count(connectivity.edgeTriangles.offsets) +
    count(connectivity.edgeTriangles.values) + count(connectivity.pointEdges.offsets) +
    count(connectivity.pointEdges.values);
  return std::max({ elements * kElementBytes, numbers * std::int64_t{ sizeof(std::int32_t) },
    (faces + edges + vertices) * kNormalBytes });
}

int DeviceMesh::elementsWithin(std::int64_t limit)
{
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp(limit / kElementBytes - kPadding, std::int64_t{ 1 }, kMost));
}

DeviceMesh::DeviceMesh(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  Kernels& kernels)
  : connectivity_(mesh, connectivity, kernels)
{
  const std::vector<std::int32_t> order = orderElements(mesh, connectivity);
  slotCount_ = static_cast<int>(order.size());
  levels_ = levelsOver(slotCount_ / kGroupSize);
  const auto bytes = static_cast<std::int64_t>(order.size() * sizeof(std::int32_t));
  obtainBuffer(order_, bytes);
  kernels.upload(order_, 0, bytes, order.data());
  this->allocate();
}

int DeviceMesh::siteCount() const
{
  return connectivity_.faceCount() + connectivity_.edgeCount() + connectivity_.vertexCount();
}

void DeviceMesh::allocate()
{
  obtainBuffer(points_, connectivity_.vertexCount() * kPointBytes);
  obtainBuffer(faces_, connectivity_.faceCount() * kFaceBytes);
  obtainBuffer(edges_, connectivity_.edgeCount() * kEdgeBytes);
  obtainBuffer(vertices_, connectivity_.vertexCount() * kVertexBytes);
  obtainBuffer(elements_, slotCount_ * kElementBytes);
  obtainBuffer(discs_, (levels_.back().first + levels_.back().count) * kDiscBytes);
}

void DeviceMesh::move(Kernels& kernels)
{
  this->uploadPoints(kernels);
  this->buildSites(kernels);
  this->buildTree(kernels);
  gl::checkGl("building sites");
}

void DeviceMesh::pack(const TriangleMesh& mesh, const LocalCoordinates& local, double reach)
{
  constexpr double kCells = std::numeric_limits<std::uint32_t>::max();
  constexpr double kMaxQuantum = 1e-6;
  constexpr double kRounding = 1e-12;
  const PointBounds bounds = boundsOf(mesh, local);
  reach_ = bounds.farthest;
  slack_ = roundingNear(reach, reach_);
  const glm::dvec3 size = bounds.high - bounds.low;
  const double longest = std::max({ size.x, size.y, size.z });
  low_ = bounds.low;
  quantum_ = longest > 0.0 ? longest / kCells : 1.0;
  fixedPoint_ = quantum_ <= kMaxQuantum || longest == 0.0;
  flatHeight_ = fixedPoint_ ? 4.0 * quantum_
                            : std::min(kRounding * (bounds.farthest + 1.0), SiteSet::kMinHeight);
  if (longest == 0.0)
  {
    flatHeight_ = 0.0;
  }
  packed_.clear();
  for (const Point3& point : mesh.points)
  {
    const glm::dvec3 x = local.toLocal(point);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (fixedPoint_)
      {
        packed_.push_back(
          static_cast<std::uint32_t>(std::min((x[axis] - low_[axis]) / quantum_ + 0.5, kCells)));
        continue;
      }
      std::uint32_t halves[2];
      std::memcpy(halves, &x[axis], sizeof(halves));
      packed_.insert(packed_.end(), halves, halves + 2);
    }
  }
}

void DeviceMesh::uploadPoints(Kernels& kernels)
{
  const auto bytes = static_cast<std::int64_t>(packed_.size() * sizeof(std::uint32_t));
  obtainBuffer(positions_, bytes);
  kernels.upload(positions_, 0, bytes, packed_.data());
  const gl::ShaderProgram& kernel = gl::cachedProgram("points.comp");
  kernel.set("count", 3 * connectivity_.vertexCount());
  kernel.set("fixedPoint", fixedPoint_ ? 1 : 0);
  kernel.set("low", low_);
  kernel.set("quantum", quantum_);
  kernels.startItems(kernel, { &positions_, &points_ },
    std::int64_t{ 3 } * connectivity_.vertexCount());
}

void DeviceMesh::buildSites(Kernels& kernels) const
{
  const gl::ShaderProgram& faces = gl::cachedProgram("faces.comp");
  this->describe(faces);
  faces.set("flatHeight", flatHeight_);
  faces.set("minHeight", SiteSet::kMinHeight);
  kernels.startItems(faces, { &connectivity_.buffer(), &points_, &faces_ },
    connectivity_.faceCount());
  const gl::ShaderProgram& edges = gl::cachedProgram("edges.comp");
  this->describe(edges);
  kernels.startItems(edges, { &connectivity_.buffer(), &points_, &faces_, &edges_ },
    connectivity_.edgeCount());
  const gl::ShaderProgram& vertices = gl::cachedProgram("vertices.comp");
  this->describe(vertices);
  kernels.startItems(vertices, { &connectivity_.buffer(), &points_, nullptr, &edges_, &vertices_ },
    connectivity_.vertexCount());
  const gl::ShaderProgram& elements = gl::cachedProgram("elements.comp");
  this->describe(elements);
  elements.set("slotCount", slotCount_);
  kernels.startItems(elements,
    { &connectivity_.buffer(), &points_, &faces_, &edges_, &vertices_, &order_, &elements_ },
    slotCount_);
}

void DeviceMesh::buildTree(Kernels& kernels) const
{
  const gl::ShaderProgram& groups = gl::cachedProgram("group_discs.comp");
  this->describe(groups);
  groups.set("groupCount", levels_[0].count);
  groups.set("slack", slack_);
  kernels.startItems(groups,
    { &connectivity_.buffer(), &points_, &faces_, &edges_, &vertices_, &order_, &discs_ },
    std::int64_t{ kGroupSize } * levels_[0].count);
  const gl::ShaderProgram& nodes = gl::cachedProgram("node_discs.comp");
  nodes.set("slack", slack_);
  for (std::size_t level = 1; level < levels_.size(); ++level)
  {
    nodes.set("below", levels_[level - 1].first);
    nodes.set("belowCount", levels_[level - 1].count);
    nodes.set("first", levels_[level].first);
    kernels.startItems(nodes, { nullptr, &discs_ }, levels_[level].count);
  }
}

} // namespace medial
