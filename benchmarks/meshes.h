#pragma once

#include "medial/triangle_mesh.h"

#include <string>

namespace medial::benchmark
{

/// A mesh that a suite asks for.
struct MeshRequest
{
  std::string name;
  std::string file;   ///< in the folder of real meshes; empty for a generated shape
  int triangles = 0;  ///< of the shape that stands in where the file is absent
  bool given = false; ///< the user named the file, so nothing may stand in for it
};

struct BenchmarkMesh
{
  std::string name;
  TriangleMesh mesh;
  bool generated = false;
};

/// Reads the real mesh from the folder in the environment variable MEDIAL_MODELS, or else from
/// ../shared/models beside the sources; makes a bumpy torus if there is none, or if `generatedOnly`
/// is set and the user did not name the file.
/// @throws Error if the file cannot be read.
BenchmarkMesh provideMesh(const MeshRequest& request, bool generatedOnly);

/// A closed torus about the z axis with about so many triangles, whose tube has bumps of several
/// sizes.
TriangleMesh bumpyTorus(int triangles);

} // namespace medial::benchmark
