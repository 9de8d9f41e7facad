#pragma once

#include "medial/distance_field.h"
#include "medial/grid.h"
#include "medial/triangle_mesh.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// What a method computes at every grid point, x fastest. An array that the method does not compute
/// is empty.
struct FieldResult
{
  std::vector<float> distance;        ///< world units, unsigned
  std::vector<std::int32_t> triangle; ///< a triangle that holds the closest point
  /// Wall-clock seconds of each phase, in order: ("build", ...), ("query", ...). Tables report
  /// their sum.
  std::vector<std::pair<std::string, double>> seconds;
  /// Other figures worth a column, such as fragments per voxel.
  std::vector<std::pair<std::string, double>> figures;
};

/// One way to compute a whole distance field: ours, a peer's or a published one. Each runs as suits
/// it best, on all cores.
class FieldMethod
{
public:
  virtual ~FieldMethod() = default;

  virtual std::string name() const = 0;
  /// The field of a mesh in memory, into arrays in memory; everything in between is timed.
  virtual FieldResult compute(const TriangleMesh& mesh, const Grid& grid) = 0;
};

// One factory per method; those of peers exist only if CMake found the library.
std::unique_ptr<FieldMethod> makeMedialMethod(Engine engine);
std::unique_ptr<FieldMethod> makePublishedMethod();
std::unique_ptr<FieldMethod> makeHavocMethod();
std::unique_ptr<FieldMethod> makeEmbreeMethod();
std::unique_ptr<FieldMethod> makeCgalMethod();
std::unique_ptr<FieldMethod> makeOpenVdbMethod(int bandVoxels); ///< 0: the whole grid
std::unique_ptr<FieldMethod> makeVtkMethod();

} // namespace medial::benchmark
