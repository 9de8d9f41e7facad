#include "vtkMeshProximity.h"

#include "vtkLinearTransform.h"
#include "vtkMedialExecution.h"
#include "vtkMedialProgress.h"
#include "vtkMedialTimes.h"
#include "vtkMeshProximityInternals.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProximityConversion.h"

#include "medial/proximity.h"

#include <algorithm>

vtkStandardNewMacro(vtkMeshProximity);
vtkCxxSetObjectMacro(vtkMeshProximity, TransformA, vtkLinearTransform);
vtkCxxSetObjectMacro(vtkMeshProximity, TransformB, vtkLinearTransform);

namespace
{

/// The share of the work that moves and converts meshes; the rest is the library's.
constexpr double ConversionShare = 0.2;

} // namespace

//------------------------------------------------------------------------------
vtkMeshProximity::vtkMeshProximity()
  : Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(3);
  vtkKeepTimes(this);
}

//------------------------------------------------------------------------------
vtkMeshProximity::~vtkMeshProximity()
{
  this->SetTransformA(nullptr);
  this->SetTransformB(nullptr);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkMeshProximity::GetMovedA()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkMeshProximity::GetMovedB()
{
  return this->GetOutput(2);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkMeshProximity::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  for (vtkLinearTransform* transform : { this->TransformA, this->TransformB })
  {
    time = transform ? std::max(time, transform->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
void vtkMeshProximity::Execute(const std::vector<vtkPolyData*>& inputs,
  const std::vector<vtkPolyData*>& outputs)
{
  vtkProgressBridge bridge(this);
  vtkProgressPart progress(bridge, ConversionShare, 1.0);
  medial::ProximityOptions options;
  options.separation = this->Separation != 0;
  options.maxSeparation = this->MaximumSeparation;
  options.depths = this->Depths != 0;
  options.translationalDepth = this->TranslationalDepth != 0;
  options.maxContacts = this->MaximumNumberOfContacts;
  options.depthTolerance = this->DepthTolerance;
  options.execution = vtkToExecution(this->NumberOfThreads, progress);

  bridge.ReportOrStop(0.0, "meshes");
  this->Internals->Move(0, inputs[0], this->TransformA, outputs[1]);
  this->Internals->Move(1, inputs[1], this->TransformB, outputs[2]);
  const medial::Proximity& proximity = this->Internals->Compute(options);
  vtkProximityConversion::PointSet points;
  points.AddWitnesses(proximity);
  points.AddContacts(proximity);
  points.ShareWith(outputs[0]);
  vtkProximityConversion::AddFigures(proximity, options, outputs[0]);
  if (options.depths)
  {
    vtkProximityConversion::AddDepths(proximity, proximity.depthsOfA, this->Internals->GetMesh(0),
      outputs[1]);
    vtkProximityConversion::AddDepths(proximity, proximity.depthsOfB, this->Internals->GetMesh(1),
      outputs[2]);
  }
}

//------------------------------------------------------------------------------
void vtkMeshProximity::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TransformA: " << this->TransformA << "\n";
  os << indent << "TransformB: " << this->TransformB << "\n";
  os << indent << "Separation: " << (this->Separation ? "On" : "Off") << "\n";
  os << indent << "MaximumSeparation: " << this->MaximumSeparation << "\n";
  os << indent << "Depths: " << (this->Depths ? "On" : "Off") << "\n";
  os << indent << "TranslationalDepth: " << (this->TranslationalDepth ? "On" : "Off") << "\n";
  os << indent << "MaximumNumberOfContacts: " << this->MaximumNumberOfContacts << "\n";
  os << indent << "DepthTolerance: " << this->DepthTolerance << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
