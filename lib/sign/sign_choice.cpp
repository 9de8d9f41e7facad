#include "sign/sign_choice.h"

#include "medial/error.h"
#include "sign/ambiguity.h"
#include "sign/lid_offsets.h"
#include "sign/surface_orientation.h"

#include <iomanip>
#include <sstream>
#include <string>

namespace medial
{
namespace
{

/// Auto gives up the sign if the winding number is ambiguous at a larger share of the grid and the
/// lids are a larger share of the closed surface: a vessel that is cut at its ends is a solid, a
/// hemisphere or a box without a side is not.
constexpr double kMaxAmbiguousShare = 0.01;
constexpr double kMaxLidShare = 0.125;
/// A soup of single triangles has no inside: Auto closes at most this many edges of holes for each
/// triangle, but few in any case.
constexpr std::int64_t kFewRimEdges = 1000;
constexpr double kMaxRimShare = 0.5;

bool isTorn(std::int64_t rimEdges, std::size_t triangles)
{
  return rimEdges > kFewRimEdges &&
    static_cast<double>(rimEdges) > kMaxRimShare * static_cast<double>(triangles);
}

/// Grid points are taken this far from where they are, local units: symmetric meshes have faces and
/// lids exactly through grid points, where rounding would decide, and not always alike.
const glm::dvec3 kShift(1.1e-6, 1.7e-6, 2.3e-6);

void requirePseudonormals(const MeshConnectivity& connectivity)
{
  if (!connectivity.closed() || !connectivity.oriented())
  {
    throw Error(ErrorCode::InvalidInput,
      "sign method pseudonormal needs a closed, consistently oriented mesh; this one has " +
        std::to_string(connectivity.boundaryEdges) + " boundary, " +
        std::to_string(connectivity.nonManifoldEdges) + " non-manifold and " +
        std::to_string(connectivity.misorientedEdges) +
        " misoriented edges; use auto, winding or none");
  }
}

std::string count(std::int64_t number, const char* what)
{
  return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

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
                           : count(report.holes, "hole") + " with " +
      count(report.rimEdges, "edge") + " closed in thought";
}

} // namespace

SignChoice::SignChoice(SignMethod requested, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const GridFrame& frame,
  SurfaceOrienter& orienter, const Checkpoint& checkpoint)
  : frame_(frame)
  , checkpoint_(checkpoint)
{
  frame_.first += kShift;
  report_.reason = std::string("sign method ") +
    (requested == SignMethod::None ? "none" : "pseudonormal") + " was asked for";
  switch (requested)
  {
    case SignMethod::Pseudonormal:
      requirePseudonormals(connectivity);
      report_.method = requested;
      directions_.assign(mesh.triangles.size(),
        static_cast<std::int8_t>(connectivity.signedVolume < 0.0 ? -1 : 1));
      break;
    case SignMethod::Winding:
      if (mesh.triangles.empty())
      {
        throw Error(ErrorCode::InvalidInput,
          "sign method winding needs triangles; this mesh has none; use auto or none");
      }
      this->wind(requested, mesh, orienter.orient(mesh, connectivity), grid);
      break;
    case SignMethod::Auto:
      report_.reason = "the mesh has no triangles";
      if (!mesh.triangles.empty())
      {
        this->wind(requested, mesh, orienter.orient(mesh, connectivity), grid);
      }
      break;
    case SignMethod::None:
      break;
  }
}

void SignChoice::wind(SignMethod requested, const TriangleMesh& mesh,
  const SurfaceOrientation& orientation, const Grid& grid)
{
  report_.rimEdges = static_cast<std::int64_t>(orientation.rim.size());
  if (requested == SignMethod::Auto && isTorn(report_.rimEdges, mesh.triangles.size()))
  {
    report_.reason =
      "the mesh does not define an inside: its holes have " + count(report_.rimEdges, "edge");
    return;
  }
  surface_ = closeSurface(mesh, orientation, frame_);
  report_.holes = surface_.holes;
  report_.copies = orientation.copies;
  report_.turned = orientation.turned;
  if (surface_.holes > 0)
  {
    lids_ = std::make_unique<WindingNumber>(surface_.lids());
    lids_->joinTriangles();
    report_.ambiguousShare = ambiguousShare(surface_.chain, *lids_, frame_, grid, checkpoint_);
    report_.lidShare = surface_.lidShare();
  }
  const bool clear =
    report_.ambiguousShare <= kMaxAmbiguousShare || report_.lidShare <= kMaxLidShare;
  report_.method =
    clear || requested == SignMethod::Winding ? SignMethod::Winding : SignMethod::None;
  report_.reason = windingReason(report_);
  if (report_.method == SignMethod::Winding)
  {
    directions_ = orientation.directions;
    weights_ = orientation.weights;
  }
}

std::optional<InsideRows> SignChoice::insideRows(const Extent& extent) const
{
  if (report_.method != SignMethod::Winding)
  {
    return {};
  }
  std::vector<SliceCrossings> slices = rowCrossings(surface_.chain, frame_, extent);
  if (lids_)
  {
    subtractLids(*lids_, frame_, extent, checkpoint_, slices);
  }
  return InsideRows(extent, slices);
}

} // namespace medial
