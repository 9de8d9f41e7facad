#pragma once

#include "medial/triangle_mesh.h"

#include <string>
#include <vector>

namespace medial::benchmark
{

/// Two meshes that deform, approach, touch and overlap.
struct MovingPair
{
  std::string name;
  TriangleMesh a, b;                                 ///< in the first frame
  std::vector<std::vector<Point3>> pointsA, pointsB; ///< by frame
};

/// A mesh and a copy of it that is turned by half a turn about y. Both bend and twist in each their
/// own phase, and the copy comes along x: from a gap between the bounding boxes of 15 % of their
/// size until they overlap by 30 %. The longest side of the mesh becomes 1.
MovingPair deformingPair(const std::string& name, const TriangleMesh& mesh, int frames);

/// The same, but the shapes are the frames of an animation, there and back again. The copy is half
/// the animation ahead.
MovingPair animatedPair(const std::string& name, const TriangleMesh& mesh,
  const std::vector<std::vector<Point3>>& shapes, int frames);

} // namespace medial::benchmark
