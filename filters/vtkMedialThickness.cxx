#include "vtkMedialThickness.h"

#include "vtkDataObject.h"
#include "vtkDistributedInput.h"
#include "vtkInformationVector.h"
#include "vtkMedialEnumerations.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialProgress.h"
#include "vtkMedialRanks.h"
#include "vtkMeshConversion.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkSurfacePiece.h"
#include "vtkThicknessConversion.h"

#include "medial/error.h"
#include "medial/ranks.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

constexpr vtkMedialEnumeration<medial::ThicknessMethod, 3> MethodValues = { "Method",
  {
    { vtkMedialThickness::BALL, medial::ThicknessMethod::Ball, "Ball" },
    { vtkMedialThickness::RAY, medial::ThicknessMethod::Ray, "Ray" },
    { vtkMedialThickness::WALL, medial::ThicknessMethod::Wall, "Wall" },
  } };

//------------------------------------------------------------------------------
// Nothing for 0; the library checks all else.
std::optional<double> LimitOf(double value)
{
  return value != 0.0 ? std::optional(value) : std::nullopt;
}

//------------------------------------------------------------------------------
// What the parameters ask for.
struct Request
{
  medial::ThicknessOptions Options;
  medial::ThicknessLimits Limits;
  std::optional<double> MaximumEdgeLength;

  bool IsLimited() const { return this->Limits.min || this->Limits.max; }
  bool NeedsInside() const { return this->IsLimited() && this->Options.side != medial::Side::Both; }
};

//------------------------------------------------------------------------------
Request ToRequest(vtkMedialThickness* filter, vtkProgressBridge& progress)
{
  Request request;
  request.Limits = { LimitOf(filter->GetMinimumThickness()),
    LimitOf(filter->GetMaximumThickness()) };
  request.MaximumEdgeLength = LimitOf(filter->GetMaximumEdgeLength());
  request.Options.angle = filter->GetAngle();
  request.Options.side = vtkMedialSides.ToLibrary(filter->GetSide());
  request.Options.method = MethodValues.ToLibrary(filter->GetMethod());
  request.Options.cells = filter->GetCellValues() || request.IsLimited();
  request.Options.execution = vtkToExecution(filter->GetNumberOfThreads(), progress);
  if (request.IsLimited())
  {
    medial::checkThicknessLimits(request.Limits);
  }
  return request;
}

//------------------------------------------------------------------------------
// The parameters that must be the same on all ranks, a line with a name and a value each.
std::string Describe(vtkMedialThickness* filter)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "Angle " << filter->GetAngle() << "\nSide " << filter->GetSideAsString() << "\nMethod "
       << filter->GetMethodAsString() << "\nCellValues " << filter->GetCellValues()
       << "\nMaximumEdgeLength " << filter->GetMaximumEdgeLength() << "\nMinimumThickness "
       << filter->GetMinimumThickness() << "\nMaximumThickness " << filter->GetMaximumThickness()
       << '\n';
  return text.str();
}

//------------------------------------------------------------------------------
void AddFigures(const medial::Thickness& thickness, vtkPolyData* output)
{
  vtkMedialFigures figures(output);
  figures.AddNumber("MinThickness", thickness.min);
  figures.AddNumber("Percentile5Thickness", thickness.percentile5);
  figures.AddNumber("MedianThickness", thickness.median);
  figures.AddNumber("Percentile95Thickness", thickness.percentile95);
  figures.AddNumber("MaxThickness", thickness.max);
  figures.AddNumber("ShareWithout", thickness.shareWithout());
}

} // namespace

vtkStandardNewMacro(vtkMedialThickness);

//------------------------------------------------------------------------------
vtkMedialThickness::vtkMedialThickness()
  : Controller(vtkMultiProcessController::GetGlobalController())
{
}

//------------------------------------------------------------------------------
vtkMedialThickness::~vtkMedialThickness() = default;

//------------------------------------------------------------------------------
const char* vtkMedialThickness::GetSideAsString()
{
  return vtkMedialSides.NameOf(this->Side);
}

//------------------------------------------------------------------------------
const char* vtkMedialThickness::GetMethodAsString()
{
  return MethodValues.NameOf(this->Method);
}

//------------------------------------------------------------------------------
vtkCxxDistributedInputMacro(vtkMedialThickness);

//------------------------------------------------------------------------------
int vtkMedialThickness::RequestData(vtkInformation* request, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  if (!this->DistributedInput)
  {
    return this->Superclass::RequestData(request, inputVector, outputVector);
  }
  const bool done = vtkRunGuarded(this, this->ErrorCode,
    [&]
    {
      this->ExecutePieces(vtkDataObject::GetData(inputVector[0]),
        vtkPolyData::GetData(outputVector));
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialThickness::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkPolyData* input = inputs[0];
  vtkPolyData* output = outputs[0];
  vtkProgressBridge progress(this);
  const Request request = ToRequest(this, progress);
  const medial::Execution& execution = request.Options.execution;
  medial::TriangleMesh mesh = medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(input));
  medial::MeshConnectivity connectivity = medial::analyseConnectivity(mesh, execution);
  if (request.NeedsInside())
  {
    medial::requireInside(mesh, connectivity, execution);
  }
  const bool divided = request.MaximumEdgeLength.has_value();
  if (divided)
  {
    medial::Subdivision fine = medial::subdivide(mesh, *request.MaximumEdgeLength, execution);
    vtkThicknessConversion::Subdivide(input, fine, output);
    mesh = std::move(fine.mesh);
    connectivity = medial::analyseConnectivity(mesh, execution);
  }
  else
  {
    output->ShallowCopy(input);
  }
  const medial::Thickness thickness = medial::computeThickness(mesh, connectivity, request.Options);
  vtkThicknessConversion::AddThickness(thickness, mesh, output, divided);
  if (request.IsLimited())
  {
    vtkThicknessConversion::AddRegions(
      medial::findThicknessRegions(mesh, thickness, request.Limits), mesh, output, divided);
  }
  AddFigures(thickness, output);
}

//------------------------------------------------------------------------------
// Each rank keeps its piece, and its values are those that the whole surface has there.
void vtkMedialThickness::ExecutePieces(vtkDataObject* input, vtkPolyData* output)
{
  vtkProgressBridge progress(this);
  Request request;
  vtkSurfacePiece piece;
  vtkMedialRanks ranks(this->Controller);
  const std::vector<vtkPieceFacts> facts = ranks.Meet(vtkMedialRanks::Stage::Data, Describe(this),
    [&]
    {
      request = ToRequest(this, progress);
      piece = vtkSurfacePiece(input);
      return piece.Facts();
    });
  medial::agree(ranks,
    [&]
    {
      medial::SurfacePiece surface = piece.Numbered(ranks, facts);
      if (request.NeedsInside())
      {
        medial::requireInside(ranks, surface, request.Options.execution);
      }
      std::optional<medial::PieceSubdivision> fine;
      if (request.MaximumEdgeLength)
      {
        fine =
          medial::subdivide(ranks, surface, *request.MaximumEdgeLength, request.Options.execution);
      }
      medial::RankCounts counts;
      medial::SurfacePiece& measured = fine ? fine->piece : surface;
      const medial::Thickness thickness =
        medial::computeThickness(ranks, measured, request.Options, &counts);
      std::vector<medial::ThicknessRegion> regions;
      if (request.IsLimited())
      {
        regions = medial::findThicknessRegions(ranks, measured, thickness, request.Limits);
      }
      if (fine)
      {
        const std::vector<std::int64_t> numbers = surface.mesh.triangleCells;
        vtkNew<vtkPolyData> undivided;
        piece.ToPolyData(input, surface.mesh, undivided);
        vtkThicknessConversion::Subdivide(undivided, surface.mesh, numbers, *fine, output);
      }
      else
      {
        piece.ToPolyData(input, surface.mesh, output);
      }
      const bool divided = fine.has_value();
      vtkThicknessConversion::AddThickness(thickness, measured.mesh, output, divided);
      if (request.IsLimited())
      {
        vtkThicknessConversion::AddRegions(regions, measured.mesh, output, divided);
      }
      AddFigures(thickness, output);
      vtkMedialFigures(output).AddRankCounts(counts);
    });
}

//------------------------------------------------------------------------------
void vtkMedialThickness::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "Side: " << this->GetSideAsString() << "\n";
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "CellValues: " << (this->CellValues ? "On" : "Off") << "\n";
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
  os << indent << "MinimumThickness: " << this->MinimumThickness << "\n";
  os << indent << "MaximumThickness: " << this->MaximumThickness << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
  os << indent << "DistributedInput: " << (this->DistributedInput ? "On" : "Off") << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
}
