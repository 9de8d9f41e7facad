#include "sign/sign_decision.h"

#include "base/counted.h"

#include <iomanip>
#include <sstream>

namespace medial
{
namespace
{

/// Auto gives up the sign if the winding number is ambiguous at a larger share of the grid and the
/// lids are a larger share of the closed surface: a vessel that is cut at its ends is a solid, a
/// hemisphere or a box without a side is not.
constexpr double kMaxAmbiguousShare = 0.01;
constexpr double kMaxLidShare = 0.125;
/// Auto closes at most this many edges of holes for each triangle, but few in any case.
constexpr std::int64_t kFewRimEdges = 1000;
constexpr double kMaxRimShare = 0.5;

/// Says why the sign is from winding numbers, or why it cannot be.
std::string windingReason(const SignReport& report)
{
  if (report.method == SignMethod::None)
  {
    std::ostringstream text;
    text << std::setprecision(3) << "the mesh does not define an inside: its winding number is "
         << "between 1/4 and 3/4 at " << 100.0 * report.ambiguousShare
         << " % of the grid, and lids of its holes would be " << 100.0 * report.lidShare
         << " % of the surface";
    return text.str();
  }
  return report.holes == 0 ? "the mesh is closed"
                           : counted(report.holes, "hole") + " with " +
      counted(report.rimEdges, "edge") + " closed in thought";
}

} // namespace

GridFrame besideGrid(GridFrame frame)
{
  frame.first += kBeside;
  return frame;
}

std::string requestedReason(SignMethod requested)
{
  return std::string("sign method ") + (requested == SignMethod::None ? "none" : "pseudonormal") +
    " was asked for";
}

Error noPseudonormals(std::int64_t boundary, std::int64_t nonManifold, std::int64_t misoriented)
{
  return { ErrorCode::InvalidInput,
    "sign method pseudonormal needs a closed, consistently oriented mesh; this one has " +
      std::to_string(boundary) + " boundary, " + std::to_string(nonManifold) +
      " non-manifold and " + std::to_string(misoriented) +
      " misoriented edges; use auto, winding or none" };
}

bool isTorn(std::int64_t rimEdges, std::size_t triangles)
{
  return rimEdges > kFewRimEdges &&
    static_cast<double>(rimEdges) > kMaxRimShare * static_cast<double>(triangles);
}

std::string tornReason(std::int64_t rimEdges)
{
  return "the mesh does not define an inside: its holes have " + counted(rimEdges, "edge");
}

void decideWinding(SignMethod requested, SignReport& report)
{
  const bool clear = report.ambiguousShare <= kMaxAmbiguousShare || report.lidShare <= kMaxLidShare;
  report.method =
    clear || requested == SignMethod::Winding ? SignMethod::Winding : SignMethod::None;
  report.reason = windingReason(report);
}

} // namespace medial
