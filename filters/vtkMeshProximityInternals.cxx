#include "vtkMeshProximityInternals.h"

#include "vtkLinearTransform.h"
#include "vtkMatrix4x4.h"
#include "vtkMeshConversion.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTransformFilter.h"

#include "medial/error.h"

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace
{

//------------------------------------------------------------------------------
bool HaveSameCells(const medial::TriangleMesh& a, const medial::TriangleMesh& b)
{
  return a.points.size() == b.points.size() && a.pointOfInput == b.pointOfInput &&
    a.triangles == b.triangles && a.segments == b.segments && a.vertices == b.vertices &&
    a.triangleCells == b.triangleCells && a.segmentCells == b.segmentCells &&
    a.vertexCells == b.vertexCells;
}

//------------------------------------------------------------------------------
void RequireInvertible(vtkLinearTransform* transform)
{
  vtkMatrix4x4* matrix = transform->GetMatrix();
  const double determinant = matrix->Determinant();
  if (!std::isfinite(determinant) || determinant == 0.0)
  {
    std::ostringstream message;
    message << "the determinant " << determinant << " of the transform is not finite and not 0";
    throw medial::Error(medial::ErrorCode::InvalidInput, message.str());
  }
}

//------------------------------------------------------------------------------
// In double precision: what is in single precision moves in steps far from the origin.
void Transform(vtkPolyData* input, vtkLinearTransform* transform, vtkPolyData* moved)
{
  vtkNew<vtkPolyData> copy; // the input belongs to a pipeline of its own
  copy->ShallowCopy(input);
  vtkNew<vtkTransformFilter> filter;
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->SetTransform(transform);
  filter->SetInputData(copy);
  filter->Update();
  moved->ShallowCopy(filter->GetOutput());
}

} // namespace

//------------------------------------------------------------------------------
// Cells are compared rather than their times: which points are welded depends on the positions, and
// a reader makes the cells of each time step anew.
void vtkMeshProximity::vtkInternals::Body::Update(vtkPolyData* input)
{
  if (input == this->Input && input->GetMTime() == this->InputTime)
  {
    return;
  }
  this->Input = nullptr;
  medial::TriangleMesh mesh = medial::buildTriangleMesh(vtkMeshConversion::ToMeshInput(input));
  if (!HaveSameCells(mesh, this->Mesh))
  {
    this->Mesh = std::move(mesh);
    this->IsNew = true;
  }
  this->Input = input;
  this->InputTime = input->GetMTime();
}

//------------------------------------------------------------------------------
void vtkMeshProximity::vtkInternals::Body::MovePoints(vtkPolyData* moved)
{
  for (std::size_t i = 0; i < this->Mesh.pointOfInput.size(); ++i)
  {
    const int point = this->Mesh.pointOfInput[i];
    if (point >= 0)
    {
      medial::Point3 x;
      moved->GetPoint(static_cast<vtkIdType>(i), x.data());
      medial::requireUsable(i, x);
      this->IsMoved = this->IsMoved || x != this->Mesh.points[point];
      this->Mesh.points[point] = x;
    }
  }
}

//------------------------------------------------------------------------------
void vtkMeshProximity::vtkInternals::Move(int port, vtkPolyData* input,
  vtkLinearTransform* transform, vtkPolyData* moved)
{
  Body& body = this->Bodies[port];
  try
  {
    body.Update(input);
    if (transform)
    {
      RequireInvertible(transform);
      Transform(input, transform, moved);
    }
    else
    {
      moved->ShallowCopy(input);
    }
    body.MovePoints(moved);
  }
  catch (const medial::Error& error)
  {
    const std::string name = port == 0 ? "mesh A: " : "mesh B: ";
    throw medial::Error(error.code(), name + error.what());
  }
}

//------------------------------------------------------------------------------
const medial::Proximity& vtkMeshProximity::vtkInternals::Compute(
  const medial::ProximityOptions& options)
{
  if (!this->Solver || this->Bodies[0].IsNew || this->Bodies[1].IsNew)
  {
    this->Solver.emplace(
      std::vector<medial::TriangleMesh>{ this->Bodies[0].Mesh, this->Bodies[1].Mesh });
  }
  else
  {
    for (int port = 0; port < 2; ++port)
    {
      if (this->Bodies[port].IsMoved)
      {
        this->Solver->setPoints(port, this->Bodies[port].Mesh.points);
      }
    }
  }
  for (Body& body : this->Bodies)
  {
    body.IsNew = false;
    body.IsMoved = false;
  }
  try
  {
    return this->Solver->compute(options).front();
  }
  catch (...)
  {
    this->Solver.reset(); // stopped halfway, it is of no use any more
    throw;
  }
}
