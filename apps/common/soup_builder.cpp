#include "soup_builder.h"

#include "failure.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

namespace medial::app
{

void refuse(const std::string& why)
{
  throw Failure(ExitCode::BadInput, why);
}

void refuseLine(int line, const std::string& why)
{
  refuse(line > 0 ? "line " + std::to_string(line) + ": " + why : why);
}

SoupBuilder::SoupBuilder()
{
  points_->SetDataTypeToDouble();
}

SoupBuilder::~SoupBuilder() = default;

void SoupBuilder::addPoint(double x, double y, double z)
{
  points_->InsertNextPoint(x, y, z);
}

void SoupBuilder::addFace(const std::vector<long long>& pointIds, int line)
{
  if (pointIds.size() < 3)
  {
    add(pointIds.size() == 2 ? lines_ : vertices_, pointIds, line);
    return;
  }
  add(faces_, pointIds, line);
}

void SoupBuilder::addLine(const std::vector<long long>& pointIds, int line)
{
  add(lines_, pointIds, line);
}

void SoupBuilder::addStrip(const std::vector<long long>& pointIds, int line)
{
  add(strips_, pointIds, line);
}

void SoupBuilder::addVertices(const std::vector<long long>& pointIds, int line)
{
  add(vertices_, pointIds, line);
}

void SoupBuilder::add(vtkCellArray* cells, const std::vector<long long>& pointIds, int line)
{
  if (pointIds.empty())
  {
    refuseLine(line, "a cell without points");
  }
  cells->InsertNextCell(static_cast<int>(pointIds.size()));
  for (const long long id : pointIds)
  {
    cells->InsertCellPoint(id);
    if (id > largestIndex_)
    {
      largestIndex_ = id;
      largestIndexLine_ = line;
    }
    if (id < smallestIndex_)
    {
      smallestIndex_ = id;
      smallestIndexLine_ = line;
    }
  }
}

long long SoupBuilder::pointCount() const
{
  return points_->GetNumberOfPoints();
}

vtkSmartPointer<vtkPolyData> SoupBuilder::finish(int firstIndex) const
{
  const bool tooSmall = smallestIndex_ < 0;
  if (tooSmall || largestIndex_ >= pointCount())
  {
    const long long index = tooSmall ? smallestIndex_ : largestIndex_;
    refuseLine(tooSmall ? smallestIndexLine_ : largestIndexLine_,
      "point index " + std::to_string(index + firstIndex) + " is outside [" +
        std::to_string(firstIndex) + ", " + std::to_string(pointCount() - 1 + firstIndex) + "]");
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points_);
  mesh->SetVerts(vertices_);
  mesh->SetLines(lines_);
  mesh->SetPolys(faces_);
  mesh->SetStrips(strips_);
  return mesh;
}

} // namespace medial::app
