#pragma once

#include "proximity/moving_mesh.h"
#include "sign/winding_number.h"
#include "sites/local_coordinates.h"

#include <glm/glm.hpp>

#include <memory>

namespace medial
{

enum class Place
{
  Outside,
  Inside,
  Undefined ///< the winding number of an open mesh does not tell
};

/// Tells which positions are inside the solid of a mesh.
class SolidQuery
{
public:
  explicit SolidQuery(const MovingMesh& mesh)
    : mesh_(mesh)
  {
  }

  /// Must be called when the points of the mesh have moved.
  void update();
  /// Whether the surface has holes.
  bool open() const { return open_ != nullptr; }
  /// Several threads may ask at once.
  Place placeOf(const glm::dvec3& x) const;

private:
  /// The generalised winding number of an open mesh.
  struct OpenSolid
  {
    explicit OpenSolid(const MovingMesh& mesh);

    LocalCoordinates local;
    WindingNumber winding;
  };

  /// The winding number of a closed mesh: the sum of what a line along x passes through before it
  /// comes to a position.
  int windingNumber(const glm::dvec3& x) const;
  int crossingsBefore(const BoxTree::Node& leaf, const glm::dvec3& x) const;

  const MovingMesh& mesh_;
  std::unique_ptr<OpenSolid> open_;
};

} // namespace medial
