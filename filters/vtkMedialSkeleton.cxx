#include "vtkMedialSkeleton.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMedialExecution.h"
#include "vtkMedialFigures.h"
#include "vtkMedialProgress.h"
#include "vtkMeshConversion.h"
#include "vtkMeshFieldInternals.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "medial/skeleton.h"
#include "medial/skeleton_resolution.h"

#include <optional>
#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkMedialSkeleton);

namespace
{

// Share of the work that is done once there is an axis.
constexpr double AxisShare = 0.8;

// Returns what to say if a resolution is not enough; empty if it is.
std::string NoteOn(const medial::SkeletonResolution& chosen)
{
  if (chosen.needed <= chosen.resolution)
  {
    return std::string();
  }
  std::ostringstream text;
  text << "the thinnest branch has a radius of " << chosen.thinnestRadius
       << ", which needs a resolution of " << chosen.needed
       << "; AutomaticResolution takes at most " << medial::kMaxSkeletonResolution;
  return text.str();
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialSkeleton::vtkMedialSkeleton()
{
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkMedialSkeleton::~vtkMedialSkeleton() = default;

//------------------------------------------------------------------------------
vtkPolyData* vtkMedialSkeleton::GetOutput()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
int vtkMedialSkeleton::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMedialSkeleton::RequestInformation(vtkInformation*, vtkInformationVector**,
  vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkMedialSkeleton::Execute(vtkPolyData* input, vtkPolyData* output)
{
  vtkProgressBridge progress(this);
  vtkProgressPart ofAxis(progress, 0.0, AxisShare);
  vtkProgressPart ofSkeleton(progress, AxisShare, 1.0);
  medial::MedialAxisOptions options;
  options.angle = this->Angle;
  options.lambda = this->MinimumLambda;
  options.topology = medial::Topology::Preserve;
  options.field = this->Internals->MakeOptions(ofAxis);
  medial::SkeletonOptions ofBranches;
  ofBranches.minBranch = this->MinimumBranch;
  ofBranches.smooth = this->Smooth != 0;
  ofBranches.execution = vtkToExecution(this->NumberOfThreads, ofSkeleton);
  this->Internals->UpdateMesh(input, options.field.execution);
  const medial::TriangleMesh& mesh = this->Internals->Mesh;
  const medial::MeshConnectivity& connectivity = this->Internals->Connectivity;
  std::optional<medial::SkeletonResolution> chosen;
  if (this->AutomaticResolution && this->GridMode == RESOLUTION)
  {
    chosen =
      medial::chooseSkeletonResolution(mesh, connectivity, options, ofBranches, this->Padding);
  }
  const medial::Grid grid = chosen
    ? medial::makeGrid(mesh.bounds(), chosen->resolution, this->Padding)
    : this->Internals->MakeGrid(input);
  const bool done = chosen && chosen->skeleton;
  const medial::MedialAxis axis =
    done ? std::move(*chosen->axis) : medial::computeMedialAxis(mesh, connectivity, grid, options);
  const medial::Skeleton skeleton =
    done ? std::move(*chosen->skeleton) : medial::computeSkeleton(axis, mesh, ofBranches);
  vtkMeshConversion::ToPolyData(skeleton, output);
  this->Internals->Record(grid, axis.statistics, output);
  const medial::CellTopology topology = medial::topologyOf(skeleton);
  vtkMedialFigures figures(output);
  figures.AddCount("Branches", static_cast<vtkIdType>(skeleton.branches.size()));
  figures.AddCount("Junctions", skeleton.junctions());
  figures.AddCount("Components", topology.components);
  figures.AddCount("Loops", topology.genus);
  vtkWarnOnce(this, axis.statistics.note);
  if (chosen)
  {
    vtkWarnOnce(this, NoteOn(*chosen));
  }
}

//------------------------------------------------------------------------------
int vtkMedialSkeleton::RequestData(vtkInformation*, vtkInformationVector** inputVector,
  vtkInformationVector* outputVector)
{
  const int piece = outputVector->GetInformationObject(0)->Get(
    vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const bool done = this->Internals->Try(
    [&]
    {
      vtkInternals::Begin(outputVector);
      if (piece <= 0)
      {
        this->Execute(vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(outputVector, 0));
      }
    });
  return done ? 1 : vtkEndWithoutOutput(this, outputVector);
}

//------------------------------------------------------------------------------
void vtkMedialSkeleton::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "AutomaticResolution: " << (this->AutomaticResolution ? "On" : "Off") << "\n";
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "MinimumLambda: " << this->MinimumLambda << "\n";
  os << indent << "MinimumBranch: " << this->MinimumBranch << "\n";
  os << indent << "Smooth: " << (this->Smooth ? "On" : "Off") << "\n";
}
