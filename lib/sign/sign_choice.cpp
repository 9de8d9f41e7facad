#include "sign/sign_choice.h"

#include "medial/error.h"
#include "sign/ambiguity.h"
#include "sign/lid_offsets.h"
#include "sign/sign_decision.h"
#include "sign/surface_orientation.h"

namespace medial
{

SignChoice::SignChoice(SignMethod requested, const TriangleMesh& mesh,
  const MeshConnectivity& connectivity, const Grid& grid, const GridFrame& frame,
  SurfaceOrienter& orienter, const Checkpoint& checkpoint)
  : frame_(besideGrid(frame))
  , checkpoint_(checkpoint)
{
  report_.reason = requestedReason(requested);
  switch (requested)
  {
    case SignMethod::Pseudonormal:
      if (!connectivity.closed() || !connectivity.oriented())
      {
        throw noPseudonormals(connectivity.boundaryEdges, connectivity.nonManifoldEdges,
          connectivity.misorientedEdges);
      }
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
    report_.reason = tornReason(report_.rimEdges);
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
  decideWinding(requested, report_);
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
