#include "proximity/enclosed_points.h"

namespace medial
{

void EnclosedPoints::begin(const MovingMesh& mesh, const std::vector<int>& cut)
{
  ++frame_;
  cutAt_.resize(mesh.size(), 0);
  seenAt_.resize(mesh.points().size(), 0);
  insideAt_.resize(mesh.points().size(), 0);
  rimAt_.resize(mesh.points().size(), 0);
  indices_.resize(mesh.points().size());
  componentAt_.resize(mesh.componentPoints().size(), 0);
  points_.clear();
  undefined_ = false;
  for (const int slot : cut)
  {
    cutAt_[slot] = frame_;
    componentAt_[mesh.components()[mesh.corners(slot)[0]]] = frame_;
    for (int i = 0; i < 3; ++i)
    {
      rimAt_[mesh.corners(slot)[i]] = frame_;
    }
  }
}

void EnclosedPoints::find(const MovingMesh& mesh, const SolidQuery& solid, const Box& solidBox,
  const std::vector<int>& cut)
{
  this->begin(mesh, cut);
  spreads_ = !solid.open();
  if (!spreads_)
  {
    // Points on either side of a hole may be inside and outside without a cut between them.
    for (const int point : mesh.usedPoints())
    {
      this->ask(mesh, solid, solidBox, point);
    }
    return;
  }
  for (const int slot : cut)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->ask(mesh, solid, solidBox, mesh.corners(slot)[i]);
    }
  }
  for (std::size_t i = 0; i < componentAt_.size(); ++i)
  {
    if (componentAt_[i] != frame_)
    {
      this->ask(mesh, solid, solidBox, mesh.componentPoints()[i]);
    }
  }
}

void EnclosedPoints::ask(const MovingMesh& mesh, const SolidQuery& solid, const Box& solidBox,
  int point)
{
  // A solid reaches no farther than its surface.
  if (seenAt_[point] == frame_ || !solidBox.contains(mesh.points()[point]))
  {
    return;
  }
  const Place place = solid.placeOf(mesh.points()[point]);
  undefined_ = undefined_ || place == Place::Undefined;
  this->spread(mesh, point, place == Place::Inside);
}

void EnclosedPoints::spread(const MovingMesh& mesh, int point, bool inside)
{
  const auto mark = [&](int reached, int from)
  {
    seenAt_[reached] = frame_;
    pending_.push_back(reached);
    if (inside)
    {
      insideAt_[reached] = frame_;
      indices_[reached] = static_cast<int>(points_.size());
      points_.push_back({ reached, from });
    }
  };
  pending_.clear();
  mark(point, -1);
  while (spreads_ && !pending_.empty())
  {
    const int next = pending_.back();
    pending_.pop_back();
    const IncidenceLists& slots = mesh.pointSlots();
    for (const int* slot = slots.begin(next); slot != slots.end(next); ++slot)
    {
      if (cutAt_[*slot] == frame_)
      {
        continue;
      }
      for (int i = 0; i < 3; ++i)
      {
        const int reached = mesh.corners(*slot)[i];
        // Of the points outside only those that are asked for need an answer.
        if (seenAt_[reached] != frame_ && (inside || rimAt_[reached] == frame_))
        {
          mark(reached, inside ? indices_[next] : -1);
        }
      }
    }
  }
}

} // namespace medial
