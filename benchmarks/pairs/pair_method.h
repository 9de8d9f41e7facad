#pragma once

#include "medial/triangle_mesh.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace medial::benchmark
{

/// What is asked of two meshes in every frame.
enum class PairQuestion
{
  Collision,         ///< yes or no
  SeparationOrDepth, ///< the separation; where they collide, the depth of every point inside
  Contacts           ///< contacts with depths; of Medial all that it can tell
};

/// What a method answers; what it does not tell is empty.
struct PairAnswer
{
  std::optional<bool> collide;
  std::optional<double> separation; ///< of the surfaces
  std::optional<double> pointDepth; ///< of the deepest point of a mesh inside the other; 0 for none
  std::optional<double> depth;      ///< the largest that the method tells, of whatever it means
  std::optional<int> contacts;
};

/// A way to tell how two deforming meshes lie to each other.
class PairMethod
{
public:
  virtual ~PairMethod() = default;

  virtual std::string name() const = 0;
  /// Takes the meshes in their first frame.
  virtual void start(const TriangleMesh& a, const TriangleMesh& b) = 0;
  /// Moves the points, which are as many and in the same order.
  virtual void update(const std::vector<Point3>& a, const std::vector<Point3>& b) = 0;
  virtual PairAnswer answer() = 0;
};

std::unique_ptr<PairMethod> makeMedialPairs(PairQuestion question);
std::unique_ptr<PairMethod> makeFclPairs(PairQuestion question);  ///< separation without depths
std::unique_ptr<PairMethod> makeOdePairs(PairQuestion question);  ///< Collision or Contacts
std::unique_ptr<PairMethod> makeBulletPairs();                    ///< contacts
std::unique_ptr<PairMethod> makeCgalPairs(PairQuestion question); ///< depths without separation
std::unique_ptr<PairMethod> makeVtkPairs();                       ///< Collision

} // namespace medial::benchmark
