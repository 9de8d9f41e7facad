#pragma once

#include "axis/bisector_point.h"
#include "axis/dual_mesh.h"
#include "axis/sheets/sheet_match.h"
#include "sites/grid_frame.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace medial
{

/// What the point of a crossing tells about sheets.
enum class SampleKind : std::uint8_t
{
  None,
  /// Some other site is a little nearer than the pair, as between the facets of a round surface.
  /// The pair tells which sheet this is, but beyond the end of a sheet it would be too wide.
  Faceted,
  Exact
};

/// Points of sheets: bisector points of crossings, selected ones and those in a band beyond.
struct SheetSamples
{
  DualMesh mesh;                          ///< of all crossings
  std::vector<BisectorPoint> points;      ///< for each crossing
  std::vector<glm::dvec3> positions;      ///< of the points, once more, close together
  std::vector<SampleKind> kinds;          ///< for each crossing
  std::vector<PairDirections> directions; ///< of the points on sheets
};

/// A sheet near a place, with what limits it as linear functions of the position.
struct SheetFit
{
  struct Linear
  {
    double value = 0.0;         ///< at the place
    glm::dvec3 gradient{ 0.0 }; ///< along the sheet
  };

  /// Fits to fewer samples tell nothing.
  static constexpr std::size_t kMinSamples = 4;

  std::size_t samples = 0;
  double weight = 0.0;        ///< of all samples
  glm::dvec3 centroid{ 0.0 }; ///< relative to the place
  glm::dvec3 normal{ 0.0 };   ///< from the side of A to that of B
  glm::dvec3 towardsA{ 0.0 }; ///< mean directions to the closest points
  glm::dvec3 towardsB{ 0.0 };
  /// Cosine of half the separation angle: the growth of the radius along the sheet.
  Linear cosine;
  /// Dot product of the vectors to the closest pair less that at the minimum angle. Near the end of
  /// the sheet of a smooth surface angles and their cosines change faster and faster; this does
  /// not.
  Linear excess;
  Linear radius;
  Linear lambda;
};

/// Fits sheets to their samples within three grid steps. Only those count that are reached from
/// sample to sample in neighbouring grid cells without a turn of either closest direction by more
/// than kMaxTurn: facets of a smooth surface turn less, the sheets that meet at a seam more.
///
/// A linear fit of symmetric data is a mean, and one of data from one side only is unbiased to
/// second order as well.
class SheetFitter
{
public:
  /// @param angle minimum separation angle, radians.
  SheetFitter(const GridFrame& frame, double angle, const SheetSamples& samples);

  /// Fits the sheet around x on which a crossing lies.
  SheetFit around(const glm::dvec3& x, std::size_t crossing);
  /// Returns the sites of the samples of the last fit, ascending.
  std::vector<int> sites() const;

private:
  struct Node : PairDirections
  {
    std::size_t crossing;
    glm::dvec3 position; ///< relative to x
    double weight;
  };

  /// @param position of the sample of a crossing, relative to the place of the fit.
  double weightOf(std::size_t crossing, const glm::dvec3& position) const;
  void gather(const glm::dvec3& x, std::size_t crossing);
  bool average(SheetFit& fit) const;
  void fitLines(SheetFit& fit) const;
  bool reach(const PairDirections& from, std::uint32_t vertex, const glm::dvec3& x);

  glm::dvec3 perStep_;
  double cosAngle_;
  const SheetSamples& samples_;
  std::vector<std::uint32_t> visited_; ///< for each crossing the last fit that has it
  std::vector<std::uint32_t> done_;    ///< for each vertex the last fit that has all around it
  std::uint32_t fit_ = 0;
  std::vector<Node> nodes_;
};

} // namespace medial
