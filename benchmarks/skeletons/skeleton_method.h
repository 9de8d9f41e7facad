#pragma once

#include "medial/triangle_mesh.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// What a method finds in a mesh.
struct Network
{
  std::int64_t branches = 0;
  std::int64_t loops = 0;
  std::int64_t components = 0;
  double length = 0.0;           ///< of all branches, world units
  std::optional<int> resolution; ///< of the grid, where there is one
};

/// A way to find the network of curves within a closed mesh.
class SkeletonMethod
{
public:
  virtual ~SkeletonMethod() = default;
  virtual std::string name() const = 0; ///< in tables
  virtual Network compute(const TriangleMesh& mesh) = 0;
};

struct SkeletonMethodEntry
{
  std::string id;
  std::function<std::unique_ptr<SkeletonMethod>()> make;
};

/// @param resolution of the grid; empty: the one that the mesh needs.
std::unique_ptr<SkeletonMethod> makeMedialSkeleton(std::optional<int> resolution);
/// Contraction by mean curvature flow (Tagliasacchi, Alhashim, Olson, Zhang, 2012).
std::unique_ptr<SkeletonMethod> makeCgalSkeleton();

} // namespace medial::benchmark
