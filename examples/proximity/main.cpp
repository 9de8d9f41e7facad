// Two soft bodies approach, touch, sink into each other and part again.
// usage: soft_bodies FOLDER [FRAMES [MESH]]
//
// Writes the meshes of each frame to FOLDER/a/0000.obj, FOLDER/b/0000.obj and so on, and prints
// their proximity. The bodies are balls, or MESH (.obj, .ply, .off or .vtk) and a copy of it.
// Pictures:
//   medial-proximity FOLDER/a FOLDER/b --sequence --animation FOLDER/pictures
#include "soft_body.h"

#include <medial/error.h>
#include <medial/mesh_io.h>
#include <medial/proximity.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace
{

namespace fs = std::filesystem;

constexpr double kFrameSeconds = 1.0 / 30;
constexpr double kSpeed = 0.6;     ///< of each body, lengths of a body in a second
constexpr double kGap = 0.21;      ///< between the bodies at the start
constexpr double kStiffness = 800; ///< of the push on a point inside, for a unit of depth
constexpr int kSteps = 4;          ///< in a frame

/// An octahedron whose triangles are split into four so many times, on the sphere of diameter 1.
medial::MeshInput makeBall(int splits)
{
  std::vector<Point3> points = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
    { 0, 0, -1 } };
  std::vector<std::array<int, 3>> triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 },
    { 2, 0, 5 }, { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (int split = 0; split < splits; ++split)
  {
    std::map<std::array<int, 2>, int> middles;
    const auto middle = [&](int a, int b)
    {
      const auto [place, isNew] =
        middles.try_emplace({ std::min(a, b), std::max(a, b) }, points.size());
      if (isNew)
      {
        points.push_back(points[a] + points[b]);
      }
      return place->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : triangles)
    {
      const int ab = middle(a, b);
      const int bc = middle(b, c);
      const int ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    triangles = finer;
  }
  medial::MeshInput ball;
  for (const Point3& point : points)
  {
    ball.points.push_back(0.5 / length(point) * point);
  }
  for (const auto& [a, b, c] : triangles)
  {
    ball.polygons.append({ a, b, c }, ball.polygons.size());
  }
  return ball;
}

/// Centres a mesh and makes its longest side 1.
void normalise(medial::TriangleMesh& mesh)
{
  const medial::Bounds bounds = mesh.bounds();
  const Point3 sides = bounds.max - bounds.min;
  const double longest = *std::max_element(sides.begin(), sides.end());
  for (Point3& point : mesh.points)
  {
    point = 1.0 / longest * (point - 0.5 * (bounds.min + bounds.max));
  }
}

/// The mesh, and a copy of it on its right, turned by half a turn about y, that come together.
std::vector<SoftBody> makeBodies(medial::TriangleMesh mesh)
{
  normalise(mesh);
  medial::TriangleMesh copy = mesh;
  const double offset = mesh.bounds().max[0] - mesh.bounds().min[0] + kGap;
  for (Point3& point : copy.points)
  {
    point = { offset - point[0], point[1], -point[2] };
  }
  return { SoftBody(std::move(mesh), { kSpeed, 0, 0 }),
    SoftBody(std::move(copy), { -kSpeed, 0, 0 }) };
}

/// The normal of the contact nearest to a point.
Point3 nearestNormal(const std::vector<medial::ProximityContact>& contacts, const Point3& point)
{
  Point3 normal{};
  double nearest = std::numeric_limits<double>::infinity();
  for (const medial::ProximityContact& contact : contacts)
  {
    const double distance = length(contact.point - point);
    if (distance < nearest)
    {
      nearest = distance;
      normal = contact.normal;
    }
  }
  return normal;
}

/// Pushes the points of a body that are inside the other out of it, each as hard as it is deep.
void pushOut(const std::vector<medial::PointDepth>& depths,
  const std::vector<medial::ProximityContact>& contacts, double direction, SoftBody& body)
{
  for (const medial::PointDepth& inside : depths)
  {
    const Point3 normal = nearestNormal(contacts, body.mesh().points[inside.point]);
    body.addForce(inside.point, direction * kStiffness * inside.depth * normal);
  }
}

void writeObj(const medial::TriangleMesh& mesh, const fs::path& folder, int frame)
{
  char name[32];
  std::snprintf(name, sizeof(name), "%04d.obj", frame);
  std::ofstream file(folder / name);
  for (const Point3& point : mesh.points)
  {
    file << "v " << point[0] << ' ' << point[1] << ' ' << point[2] << '\n';
  }
  for (const auto& [a, b, c] : mesh.triangles)
  {
    file << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
  if (!file.flush())
  {
    throw std::runtime_error("cannot write " + (folder / name).string());
  }
}

void print(int frame, const medial::Proximity& proximity)
{
  std::printf("frame %d: ", frame);
  if (proximity.collide)
  {
    std::printf("depth %.4f, %zu points inside, %zu contacts\n", proximity.depth,
      proximity.depthsOfA.size() + proximity.depthsOfB.size(), proximity.contacts.size());
  }
  else
  {
    std::printf("separation %.4f\n", proximity.separation);
  }
}

void simulate(std::vector<SoftBody> bodies, int frames, const fs::path& folder)
{
  const std::vector<fs::path> folders = { folder / "a", folder / "b" };
  for (const fs::path& one : folders)
  {
    fs::create_directories(one);
  }
  medial::ProximitySolver solver({ bodies[0].mesh(), bodies[1].mesh() });
  medial::ProximityOptions options;
  options.translationalDepth = false;
  for (int step = 0; step < frames * kSteps; ++step)
  {
    for (int i = 0; i < 2; ++i)
    {
      solver.setPoints(i, bodies[i].mesh().points);
    }
    const medial::Proximity& proximity = solver.compute(options).front();
    if (step % kSteps == 0)
    {
      const int frame = step / kSteps;
      print(frame, proximity);
      writeObj(bodies[0].mesh(), folders[0], frame);
      writeObj(bodies[1].mesh(), folders[1], frame);
    }
    // A contact's normal points from A to B.
    pushOut(proximity.depthsOfA, proximity.contacts, -1.0, bodies[0]);
    pushOut(proximity.depthsOfB, proximity.contacts, 1.0, bodies[1]);
    for (SoftBody& body : bodies)
    {
      body.step(kFrameSeconds / kSteps);
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  const int frames = argc > 2 ? std::atoi(argv[2]) : 60;
  if (argc < 2 || argc > 4 || frames < 1)
  {
    std::cerr << "usage: soft_bodies FOLDER [FRAMES [MESH]]\n";
    return 2;
  }
  try
  {
    const medial::MeshInput input = argc > 3 ? medial::readMesh(argv[3]) : makeBall(3);
    simulate(makeBodies(medial::buildTriangleMesh(input)), frames, argv[1]);
  }
  catch (const std::exception& error)
  {
    std::cerr << "soft_bodies: " << error.what() << '\n';
    return 1;
  }
}
