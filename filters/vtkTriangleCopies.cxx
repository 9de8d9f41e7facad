#include "vtkTriangleCopies.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
// The corners of a triangle in its orientation, the least first; copies have the same bits.
using Corners = std::array<medial::Point3, 3>;

Corners CornersOf(const medial::TriangleMesh& mesh, std::size_t triangle)
{
  Corners corners;
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i] = mesh.points[mesh.triangles[triangle][i]];
    for (double& coordinate : corners[i])
    {
      coordinate += 0.0; // -0 becomes 0
    }
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

//------------------------------------------------------------------------------
std::size_t RankOf(const Corners& corners, std::size_t ranks)
{
  std::uint64_t hash = 0;
  for (const medial::Point3& corner : corners)
  {
    for (const double coordinate : corner)
    {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &coordinate, sizeof(bits));
      hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32;
    }
  }
  return hash % ranks;
}

//------------------------------------------------------------------------------
bool Contains(const medial::Bounds& bounds, const Corners& corners)
{
  return std::all_of(corners.begin(), corners.end(),
    [&bounds](const medial::Point3& corner)
    {
      bool inside = true;
      for (int axis = 0; axis < 3; ++axis)
      {
        inside = inside && corner[axis] >= bounds.min[axis] && corner[axis] <= bounds.max[axis];
      }
      return inside;
    });
}

//------------------------------------------------------------------------------
using Messages = std::vector<medial::Communicator::Message>;

template <typename T>
void Append(const T& value, medial::Communicator::Message& message)
{
  const auto* const bytes = reinterpret_cast<const char*>(&value);
  message.insert(message.end(), bytes, bytes + sizeof(value));
}

template <typename T>
std::vector<T> ListOf(const medial::Communicator::Message& message)
{
  std::vector<T> list(message.size() / sizeof(T));
  if (!list.empty())
  {
    std::memcpy(static_cast<void*>(list.data()), message.data(), message.size());
  }
  return list;
}

//------------------------------------------------------------------------------
// Of triangles that several ranks have, those of all but the first: whether they are copies, in the
// order in which each rank sent them.
Messages FindCopies(const Messages& sent)
{
  std::map<Corners, std::size_t> firstRank;
  Messages replies(sent.size());
  for (std::size_t rank = 0; rank < sent.size(); ++rank)
  {
    for (const Corners& corners : ListOf<Corners>(sent[rank]))
    {
      replies[rank].push_back(firstRank.insert({ corners, rank }).first->second < rank ? 1 : 0);
    }
  }
  return replies;
}

} // namespace

//------------------------------------------------------------------------------
// A triangle that two ranks have is within the bounds of both pieces. Some rank is asked about all
// its copies.
std::vector<char> vtkFindCopies(medial::Communicator& communicator,
  const medial::TriangleMesh& mesh, const std::vector<vtkPieceFacts>& facts)
{
  const auto own = static_cast<std::size_t>(communicator.rank());
  std::vector<char> copies(mesh.triangles.size(), 0);
  Messages asked(facts.size());
  std::vector<std::vector<std::size_t>> triangles(facts.size()); // that each rank is asked about
  std::set<Corners> known;
  for (std::size_t i = 0; i < copies.size(); ++i)
  {
    const Corners corners = CornersOf(mesh, i);
    bool shared = false;
    for (std::size_t rank = 0; rank < facts.size() && !shared; ++rank)
    {
      shared = rank != own && !facts[rank].Empty && Contains(facts[rank].Bounds, corners);
    }
    if (!known.insert(corners).second)
    {
      copies[i] = 1;
    }
    else if (shared)
    {
      const std::size_t rank = RankOf(corners, facts.size());
      Append(corners, asked[rank]);
      triangles[rank].push_back(i);
    }
  }
  known.clear();
  const Messages replies =
    communicator.exchange(FindCopies(communicator.exchange(std::move(asked))));
  for (std::size_t rank = 0; rank < replies.size(); ++rank)
  {
    for (std::size_t i = 0; i < replies[rank].size(); ++i)
    {
      copies[triangles[rank][i]] = replies[rank][i];
    }
  }
  return copies;
}
