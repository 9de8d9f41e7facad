#include "vtkMedialThickness.h"

#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMeshConversion.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkThicknessConversion.h"

#include "medial/error.h"
#include "medial/subdivision.h"
#include "medial/thickness.h"
#include "medial/thickness_regions.h"

#include <optional>
#include <sstream>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
// Nothing for 0.
std::optional<double> LimitOf(const char* name, double value)
{
  if (!(value >= 0.0))
  {
    std::ostringstream text;
    text << name << " " << value << " is not 0 or more";
    throw medial::Error(medial::ErrorCode::InvalidInput, text.str());
  }
  return value > 0.0 ? std::optional(value) : std::nullopt;
}

//------------------------------------------------------------------------------
medial::ThicknessMethod ToMethod(int method)
{
  switch (method)
  {
    case vtkMedialThickness::BALL:
      return medial::ThicknessMethod::Ball;
    case vtkMedialThickness::RAY:
      return medial::ThicknessMethod::Ray;
    case vtkMedialThickness::WALL:
      return medial::ThicknessMethod::Wall;
    default:
      throw medial::Error(medial::ErrorCode::InvalidInput,
        "thickness method " + std::to_string(method) + " is outside [0, 2]");
  }
}

} // namespace

vtkStandardNewMacro(vtkMedialThickness);

//------------------------------------------------------------------------------
vtkMedialThickness::vtkMedialThickness() = default;

//------------------------------------------------------------------------------
vtkMedialThickness::~vtkMedialThickness() = default;

//------------------------------------------------------------------------------
const char* vtkMedialThickness::GetSideAsString()
{
  return vtkSideAsString(this->Side);
}

//------------------------------------------------------------------------------
const char* vtkMedialThickness::GetMethodAsString()
{
  switch (this->Method)
  {
    case BALL:
      return "Ball";
    case RAY:
      return "Ray";
    case WALL:
      return "Wall";
    default:
      return "(unknown)";
  }
}

//------------------------------------------------------------------------------
void vtkMedialThickness::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkPolyData* input = inputs[0];
  vtkPolyData* output = outputs[0];
  vtkProgressBridge progress(this);
  const medial::ThicknessLimits limits{ LimitOf("minimum thickness", this->MinimumThickness),
    LimitOf("maximum thickness", this->MaximumThickness) };
  const bool limited = limits.min || limits.max;
  medial::ThicknessOptions options;
  options.angle = this->Angle;
  options.side = vtkToSide(this->Side);
  options.method = ToMethod(this->Method);
  options.cells = this->CellValues || limited;
  options.execution = vtkToExecution(this->NumberOfThreads, progress);
  medial::TriangleMesh mesh = medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(input));
  medial::MeshConnectivity connectivity = medial::analyseConnectivity(mesh, options.execution);
  if (limited)
  {
    medial::checkThicknessLimits(limits);
    if (options.side != medial::Side::Both)
    {
      medial::requireInside(mesh, connectivity, options.execution);
    }
  }
  const bool divided = LimitOf("maximum edge length", this->MaximumEdgeLength).has_value();
  if (divided)
  {
    medial::Subdivision fine = medial::subdivide(mesh, this->MaximumEdgeLength, options.execution);
    vtkThicknessConversion::Subdivide(input, fine, output);
    mesh = std::move(fine.mesh);
    connectivity = medial::analyseConnectivity(mesh, options.execution);
  }
  else
  {
    output->ShallowCopy(input);
  }
  const medial::Thickness thickness = medial::computeThickness(mesh, connectivity, options);
  vtkThicknessConversion::AddThickness(thickness, mesh, output, divided);
  if (limited)
  {
    vtkThicknessConversion::AddRegions(medial::findThicknessRegions(mesh, thickness, limits), mesh,
      output, divided);
  }
  vtkMedialFigures figures(output);
  figures.AddNumber("MinThickness", thickness.min);
  figures.AddNumber("MedianThickness", thickness.median);
  figures.AddNumber("MaxThickness", thickness.max);
  figures.AddNumber("ShareWithout", thickness.shareWithout());
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
}
