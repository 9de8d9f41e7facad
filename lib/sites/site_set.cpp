#include "sites/site_set.h"

#include "sites/bounding_ball.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace medial
{

glm::vec4 ballAround(std::initializer_list<glm::dvec3> corners)
{
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& corner : corners)
  {
    sum += corner;
  }
  const glm::dvec3 centre = sum / static_cast<double>(corners.size());
  double radius = 0.0;
  for (const glm::dvec3& corner : corners)
  {
    radius = std::max(radius, glm::distance(centre, corner));
  }
  return { glm::vec3(centre), static_cast<float>(radius) };
}

SiteSet::SiteSet(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
{
  this->buildGeometry(mesh, connectivity, local);
  this->buildNormals(mesh);
  this->buildBalls();
}

void SiteSet::buildGeometry(const TriangleMesh& mesh, const MeshConnectivity& connectivity,
  const LocalCoordinates& local)
{
  points_.reserve(mesh.points.size());
  for (const Point3& point : mesh.points)
  {
    points_.push_back(local.toLocal(point));
  }
  for (const auto& edge : connectivity.edges)
  {
    edges_.emplace_back(edge[0], edge[1]);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& corners = mesh.triangles[t];
    faces_.emplace_back(corners[0], corners[1], corners[2]);
    const auto& edges = connectivity.triangleEdges[t];
    faceEdges_.emplace_back(edges[0], edges[1], edges[2]);
  }
  active_.assign(this->size(), 1);
  tbb::parallel_for(0, this->edgeCount(),
    [this](int edge) { active_[this->firstEdge() + edge] = this->edgeLength(edge) > 0.0; });
}

void SiteSet::buildNormals(const TriangleMesh& mesh)
{
  faceNormals_.resize(this->faceCount());
  tbb::parallel_for(0, this->faceCount(), [&](int face) { this->setNormal(mesh, face); });
  for (int face = 0; face < this->faceCount(); ++face)
  {
    if (faceNormals_[face] == glm::dvec3(0.0))
    {
      active_[this->firstEdge() + this->coveredEdge(face)] = 0;
    }
  }
}

void SiteSet::setNormal(const TriangleMesh& mesh, int face)
{
  const auto vector = [](const Point3& from, const Point3& to)
  { return glm::dvec3(to[0] - from[0], to[1] - from[1], to[2] - from[2]); };
  // Uses world coordinates: rounding to local coordinates may bend flat triangles.
  const Point3& a = mesh.points[faces_[face][0]];
  const Point3& b = mesh.points[faces_[face][1]];
  const Point3& c = mesh.points[faces_[face][2]];
  if (!hasArea(a, b, c))
  {
    faceNormals_[face] = glm::dvec3(0.0);
    active_[face] = 0;
    return;
  }
  faceNormals_[face] = glm::normalize(glm::cross(vector(a, b), vector(a, c)));
  const int longest = this->longestEdge(face);
  const glm::dvec3& p = points_[faces_[face][longest]];
  const glm::dvec3& q = points_[faces_[face][(longest + 1) % 3]];
  const glm::dvec3& r = points_[faces_[face][(longest + 2) % 3]];
  const double height = glm::length(glm::cross(q - p, r - p)) / glm::distance(p, q);
  active_[face] = height >= kMinHeight;
}

int SiteSet::longestEdge(int face) const
{
  int longest = 0;
  double longestLength = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double length =
      glm::distance(points_[faces_[face][i]], points_[faces_[face][(i + 1) % 3]]);
    if (length > longestLength)
    {
      longestLength = length;
      longest = i;
    }
  }
  return longest;
}

double SiteSet::edgeLength(int edge) const
{
  return glm::distance(points_[edges_[edge][0]], points_[edges_[edge][1]]);
}

int SiteSet::coveredEdge(int face) const
{
  const auto shorter = [this](int a, int b)
  { return std::pair(this->edgeLength(a), a) < std::pair(this->edgeLength(b), b); };
  const glm::ivec3& edges = faceEdges_[face];
  return std::max({ edges[0], edges[1], edges[2] }, shorter);
}

void SiteSet::buildBalls()
{
  balls_.resize(this->size());
  tbb::parallel_for(0, this->size(),
    [this](int site)
    {
      switch (this->kind(site))
      {
        case SiteKind::Face:
          balls_[site] = ballAround(
            { points_[faces_[site][0]], points_[faces_[site][1]], points_[faces_[site][2]] });
          return;
        case SiteKind::Edge:
        {
          const glm::ivec2& ends = edges_[site - this->firstEdge()];
          balls_[site] = ballAround({ points_[ends[0]], points_[ends[1]] });
          return;
        }
        case SiteKind::Vertex:
          balls_[site] = ballAround({ points_[site - this->firstVertex()] });
          return;
      }
    });
}

} // namespace medial
