#include "io/soup_builder.h"

#include "base/range_check.h"
#include "io/refusal.h"

#include <numeric>
#include <string>

namespace medial
{

void SoupBuilder::addFace(const std::vector<std::int64_t>& pointIds, int line)
{
  if (pointIds.size() < 3)
  {
    this->add(pointIds.size() == 2 ? soup_.lines : soup_.verts, pointIds, line);
    return;
  }
  this->add(soup_.polygons, pointIds, line);
}

void SoupBuilder::addLine(const std::vector<std::int64_t>& pointIds, int line)
{
  this->add(soup_.lines, pointIds, line);
}

void SoupBuilder::addStrip(const std::vector<std::int64_t>& pointIds, int line)
{
  this->add(soup_.strips, pointIds, line);
}

void SoupBuilder::addVertices(const std::vector<std::int64_t>& pointIds, int line)
{
  this->add(soup_.verts, pointIds, line);
}

void SoupBuilder::add(CellList& cells, const std::vector<std::int64_t>& pointIds, int line)
{
  if (pointIds.empty())
  {
    refuseLine(line, "a cell without points");
  }
  cells.append(pointIds, 0);
  for (const std::int64_t id : pointIds)
  {
    if (id > maxIndex_)
    {
      maxIndex_ = id;
      maxIndexLine_ = line;
    }
    if (id < minIndex_)
    {
      minIndex_ = id;
      minIndexLine_ = line;
    }
  }
}

void SoupBuilder::checkIndices(int firstIndex) const
{
  const bool tooSmall = minIndex_ < 0;
  if (tooSmall || maxIndex_ >= this->pointCount())
  {
    const std::int64_t index = tooSmall ? minIndex_ : maxIndex_;
    refuseLine(tooSmall ? minIndexLine_ : maxIndexLine_,
      outsideText("point index", index + firstIndex,
        closedRange<std::int64_t>(firstIndex, this->pointCount() - 1 + firstIndex)));
  }
}

MeshInput SoupBuilder::finish(int firstIndex)
{
  this->checkIndices(firstIndex);
  std::int64_t nextId = 0;
  for (CellList* cells : { &soup_.verts, &soup_.lines, &soup_.polygons, &soup_.strips })
  {
    std::iota(cells->ids.begin(), cells->ids.end(), nextId);
    nextId += cells->size();
  }
  return std::move(soup_);
}

} // namespace medial
