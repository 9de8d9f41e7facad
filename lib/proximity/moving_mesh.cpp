#include "proximity/moving_mesh.h"

#include "base/disjoint_sets.h"
#include "base/exact_sign.h"
#include "base/vectors.h"

#include <tbb/parallel_invoke.h>

#include <cmath>
#include <cstddef>

namespace medial
{

MovingMesh::MovingMesh(TriangleMesh mesh)
  : mesh_(std::move(mesh))
  , connectivity_(analyseConnectivity(mesh_))
{
  for (const auto& [a, b, c] : mesh_.triangles)
  {
    elementCorners_.emplace_back(a, b, c);
  }
  for (const auto& [a, b] : mesh_.segments)
  {
    elementCorners_.emplace_back(a, b, b);
  }
  for (const int point : mesh_.vertices)
  {
    elementCorners_.emplace_back(point);
  }
  this->findComponents();
  this->setPoints(mesh_.points);
  this->orient();
  this->build();
}

void MovingMesh::setPoints(const std::vector<Point3>& points)
{
  if (&points != &mesh_.points)
  {
    mesh_.points = points;
  }
  points_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    points_[i] = withoutTinyCoordinates(toVector(points[i]));
  }
  oriented_ = false;
}

void MovingMesh::refit()
{
  // The tree keeps the order of its elements, so weights can be set meanwhile.
  tbb::parallel_invoke(
    [this]
    {
      if (!oriented_)
      {
        this->orient();
      }
    },
    [this] { tree_.refit(points_); });
  if (tree_.worn())
  {
    this->build();
  }
}

void MovingMesh::orient()
{
  const SurfaceOrientation& orientation = orienter_.orient(mesh_, connectivity_);
  oriented_ = true;
  if (orientation.weights != orientation_.weights)
  {
    orientation_ = orientation;
    this->setWeights();
  }
}

void MovingMesh::setWeights()
{
  weights_.resize(corners_.size());
  for (int slot = 0; slot < this->size(); ++slot)
  {
    weights_[slot] =
      this->isTriangle(slot) ? orientation_.weights[this->elementIn(slot)] : std::int8_t{ 0 };
  }
}

void MovingMesh::build()
{
  tree_.build(points_, elementCorners_);
  corners_.resize(elementCorners_.size());
  slots_.resize(elementCorners_.size());
  pointSlots_.offsets.assign(points_.size() + 1, 0);
  for (int slot = 0; slot < this->size(); ++slot)
  {
    const int element = this->elementIn(slot);
    corners_[slot] = elementCorners_[element];
    slots_[element] = slot;
    for (int i = 0; i < 3; ++i)
    {
      ++pointSlots_.offsets[corners_[slot][i] + 1];
    }
  }
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    pointSlots_.offsets[i + 1] += pointSlots_.offsets[i];
  }
  pointSlots_.values.resize(pointSlots_.offsets.back());
  std::vector<int> next(pointSlots_.offsets.begin(), pointSlots_.offsets.end() - 1);
  for (std::size_t element = 0; element < elementCorners_.size(); ++element)
  {
    for (int i = 0; i < 3; ++i)
    {
      pointSlots_.values[next[elementCorners_[element][i]]++] = slots_[element];
    }
  }
  this->setWeights();
}

void MovingMesh::findComponents()
{
  DisjointSets sets(mesh_.points.size());
  components_.assign(mesh_.points.size(), -1);
  std::vector<char> used(mesh_.points.size(), 0);
  for (const glm::ivec3& corners : elementCorners_)
  {
    sets.join(corners[0], corners[1]);
    sets.join(corners[0], corners[2]);
    used[corners[0]] = used[corners[1]] = used[corners[2]] = 1;
  }
  for (int i = 0; i < static_cast<int>(used.size()); ++i)
  {
    if (used[i] == 0)
    {
      continue;
    }
    usedPoints_.push_back(i);
    const auto first = static_cast<int>(sets.find(i)); // the lowest point of the set
    if (first == i)
    {
      components_[i] = static_cast<int>(componentPoints_.size());
      componentPoints_.push_back(i);
    }
    components_[i] = components_[first];
  }
}

std::int64_t MovingMesh::cellOf(int slot) const
{
  std::size_t element = this->elementIn(slot);
  if (element < mesh_.triangles.size())
  {
    return mesh_.triangleCells[element];
  }
  element -= mesh_.triangles.size();
  return element < mesh_.segments.size() ? mesh_.segmentCells[element]
                                         : mesh_.vertexCells[element - mesh_.segments.size()];
}

} // namespace medial
