#include "simplification/ball_complex.h"

#include <algorithm>

namespace medial
{
namespace
{

void erase(std::vector<int>& list, int value)
{
  list.erase(std::remove(list.begin(), list.end(), value), list.end());
}

template <std::size_t Size>
bool contains(const std::array<int, Size>& cell, int vertex)
{
  return std::find(cell.begin(), cell.end(), vertex) != cell.end();
}

} // namespace

BallComplex::BallComplex(int vertexCount)
  : vertices_(vertexCount)
{
}

void BallComplex::addEdge(int a, int b)
{
  if (a == b || this->findEdge(a, b))
  {
    return;
  }
  const int id = this->edgeCount();
  edges_.push_back({ std::min(a, b), std::max(a, b) });
  vertices_[a].edges.push_back(id);
  vertices_[b].edges.push_back(id);
}

void BallComplex::addTriangle(int a, int b, int c)
{
  this->addEdge(a, b);
  this->addEdge(b, c);
  this->addEdge(c, a);
  if (a == b || b == c || c == a || this->hasTriangle(a, b, c))
  {
    return;
  }
  const int id = static_cast<int>(triangles_.size());
  triangles_.push_back({ a, b, c });
  for (const int vertex : triangles_.back())
  {
    vertices_[vertex].triangles.push_back(id);
  }
}

std::optional<int> BallComplex::findEdge(int a, int b) const
{
  const bool fewer = vertices_[a].edges.size() <= vertices_[b].edges.size();
  const int from = fewer ? a : b;
  const int to = fewer ? b : a;
  for (const int edge : vertices_[from].edges)
  {
    if (this->across(edge, from) == to)
    {
      return edge;
    }
  }
  return std::nullopt;
}

bool BallComplex::hasTriangle(int a, int b, int c) const
{
  const std::vector<int>& list = vertices_[a].triangles;
  return std::any_of(list.begin(), list.end(),
    [&](int t) { return contains(triangles_[t], b) && contains(triangles_[t], c); });
}

std::vector<int> BallComplex::opposite(int edge) const
{
  std::vector<int> corners;
  const auto [a, b] = edges_[edge];
  for (const int t : vertices_[a].triangles)
  {
    if (contains(triangles_[t], b))
    {
      const std::array<int, 3>& corner = triangles_[t];
      corners.push_back(corner[0] + corner[1] + corner[2] - a - b);
    }
  }
  return corners;
}

std::vector<int> BallComplex::commonNeighbours(int edge) const
{
  const auto neighbours = [this](int vertex)
  {
    std::vector<int> list;
    for (const int e : vertices_[vertex].edges)
    {
      list.push_back(this->across(e, vertex));
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  const std::vector<int> a = neighbours(edges_[edge][0]);
  const std::vector<int> b = neighbours(edges_[edge][1]);
  std::vector<int> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  return common;
}

void BallComplex::dropEdge(int edge)
{
  for (const int vertex : edges_[edge])
  {
    erase(vertices_[vertex].edges, edge);
  }
  edges_[edge] = { -1, -1 };
}

void BallComplex::dropTriangle(int triangle)
{
  for (const int vertex : triangles_[triangle])
  {
    erase(vertices_[vertex].triangles, triangle);
  }
  triangles_[triangle] = { -1, -1, -1 };
}

int BallComplex::contract(int edge)
{
  const auto [kept, gone] = edges_[edge];
  for (const int t : std::vector<int>(vertices_[gone].triangles))
  {
    std::array<int, 3> corners = triangles_[t];
    std::replace(corners.begin(), corners.end(), gone, kept);
    const bool flat = contains(triangles_[t], kept);
    if (flat || this->hasTriangle(corners[0], corners[1], corners[2]))
    {
      this->dropTriangle(t);
      continue;
    }
    triangles_[t] = corners;
    vertices_[kept].triangles.push_back(t);
  }
  this->dropEdge(edge);
  for (const int e : std::vector<int>(vertices_[gone].edges))
  {
    const int other = this->across(e, gone);
    if (this->findEdge(kept, other))
    {
      this->dropEdge(e);
      continue;
    }
    edges_[e] = { std::min(kept, other), std::max(kept, other) };
    vertices_[kept].edges.push_back(e);
  }
  vertices_[gone] = { false, {}, {} };
  return kept;
}

void BallComplex::removeVertex(int vertex)
{
  while (!vertices_[vertex].triangles.empty())
  {
    this->dropTriangle(vertices_[vertex].triangles.back());
  }
  while (!vertices_[vertex].edges.empty())
  {
    this->dropEdge(vertices_[vertex].edges.back());
  }
  vertices_[vertex].alive = false;
}

std::vector<int> BallComplex::vertices() const
{
  std::vector<int> result;
  for (int v = 0; v < this->vertexCount(); ++v)
  {
    if (this->isVertex(v))
    {
      result.push_back(v);
    }
  }
  return result;
}

std::vector<int> BallComplex::edges() const
{
  std::vector<int> result;
  for (int e = 0; e < this->edgeCount(); ++e)
  {
    if (this->isEdge(e))
    {
      result.push_back(e);
    }
  }
  return result;
}

std::vector<std::array<int, 3>> BallComplex::triangles() const
{
  std::vector<std::array<int, 3>> result;
  for (int t = 0; t < static_cast<int>(triangles_.size()); ++t)
  {
    if (this->isTriangle(t))
    {
      result.push_back(triangles_[t]);
    }
  }
  return result;
}

std::vector<int> componentsOf(const BallComplex& complex)
{
  std::vector<int> label(complex.vertexCount(), -1);
  std::vector<int> pending;
  for (const int start : complex.vertices())
  {
    if (label[start] >= 0)
    {
      continue;
    }
    label[start] = start;
    pending.push_back(start);
    while (!pending.empty())
    {
      const int vertex = pending.back();
      pending.pop_back();
      for (const int edge : complex.edgesOf(vertex))
      {
        const int other = complex.across(edge, vertex);
        if (label[other] < 0)
        {
          label[other] = start;
          pending.push_back(other);
        }
      }
    }
  }
  return label;
}

} // namespace medial
