#pragma once

#include "medial/triangle_mesh.h"

#include <memory>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// A way to compute the distances of many points from a mesh. Each runs as suits it best, on all
/// cores.
class CloudMethod
{
public:
  virtual ~CloudMethod() = default;

  virtual std::string name() const = 0;
  /// Prepares a mesh.
  virtual void start(const TriangleMesh& mesh) = 0;
  /// Returns the unsigned distances of the points, in their order; of one in every sample() only.
  virtual std::vector<double> distances(const std::vector<Point3>& points) = 0;
  /// Slow methods compute one point in so many; the others get NaN.
  virtual int sample() const { return 1; }
};

// One factory per method; those of peers exist only if CMake found the library.
std::unique_ptr<CloudMethod> makeMedialCloud(bool withSign);
/// @param sorted sort points first, and let a point begin with the triangle of the one before.
std::unique_ptr<CloudMethod> makeEmbreeCloud(bool sorted);
std::unique_ptr<CloudMethod> makeCgalCloud();
std::unique_ptr<CloudMethod> makeVtkCloud();

} // namespace medial::benchmark
