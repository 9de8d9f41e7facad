#include "web/html_mesh.h"

#include "actors.h"
#include "colours.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCleanPolyData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

namespace medial::app
{
namespace
{

constexpr double kFinestGrid = 1024.0; // boxes along the longest side
constexpr double kCoarser = 0.97;      // at most, from one grid to the next

template <std::size_t N>
void appendCells(vtkCellArray* from, HtmlMesh::Cells<N>& to)
{
  for (vtkIdType cell = 0; cell < from->GetNumberOfCells(); ++cell)
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    from->GetCellAtId(cell, count, ids);
    std::array<std::uint32_t, N> corners{};
    std::copy_n(ids, N, corners.begin());
    to.push_back(corners);
  }
}

template <std::size_t N>
HtmlMesh::Cells<N> cellsOf(const std::vector<std::array<int, N>>& from)
{
  HtmlMesh::Cells<N> cells(from.size());
  std::transform(from.begin(), from.end(), cells.begin(),
    [](const auto& corners)
    {
      std::array<std::uint32_t, N> result{};
      std::copy(corners.begin(), corners.end(), result.begin());
      return result;
    });
  return cells;
}

/// @param end of its scale; the largest value if omitted.
HtmlArray arrayOf(vtkPolyData* axis, const char* name, const char* label, const char* unit,
  std::optional<double> end = std::nullopt)
{
  HtmlArray array{ name, label, unit, 1.0, {} };
  vtkDataArray* values = axis->GetPointData()->GetArray(name);
  array.max = end.value_or(scaleEnd(values->GetNumberOfTuples() > 0 ? values->GetRange()[1] : 0.0));
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    array.values.push_back(static_cast<float>(values->GetTuple1(i)));
  }
  return array;
}

// Polygons, strips, polylines and poly-vertices come apart.
vtkSmartPointer<vtkPolyData> simpleCells(vtkPolyData* mesh)
{
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(mesh);
  triangulate->Update();
  return triangulate->GetOutput();
}

HtmlMesh withCells(vtkPolyData* simple)
{
  HtmlMesh mesh;
  mesh.points.resize(simple->GetNumberOfPoints());
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    simple->GetPoint(static_cast<vtkIdType>(i), mesh.points[i].data());
  }
  appendCells(simple->GetPolys(), mesh.triangles);
  appendCells(simple->GetLines(), mesh.lines);
  appendCells(simple->GetVerts(), mesh.vertices);
  return mesh;
}

template <std::size_t N>
void sortCells(HtmlMesh::Cells<N>& cells, const std::vector<float>& angles)
{
  const auto min = [&](const std::array<std::uint32_t, N>& corners)
  {
    float angle = std::numeric_limits<float>::max();
    for (const std::uint32_t corner : corners)
    {
      angle = std::min(angle, angles[corner]);
    }
    return angle;
  };
  std::stable_sort(cells.begin(), cells.end(),
    [&](const auto& a, const auto& b) { return min(a) > min(b); });
}

struct Box
{
  Point3 low{};
  double longest = 0.0;
};

Box boxOf(const std::vector<Point3>& points)
{
  Point3 low = points.front();
  Point3 high = low;
  for (const Point3& point : points)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], point[axis]);
      high[axis] = std::max(high[axis], point[axis]);
    }
  }
  return { low, std::max({ high[0] - low[0], high[1] - low[1], high[2] - low[2] }) };
}

// The number of the box on an axis; sides of 0 leave one box.
std::uint64_t boxNumber(double offset, double side)
{
  return side > 0.0 ? static_cast<std::uint64_t>(offset / side) : 0;
}

// For every point, the first one in the same box.
std::vector<std::uint32_t> firstOfBoxes(const std::vector<Point3>& points, const Box& box,
  double side)
{
  std::unordered_map<std::uint64_t, std::uint32_t> first;
  std::vector<std::uint32_t> result;
  result.reserve(points.size());
  for (const Point3& point : points)
  {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      key = (key << 20U) | boxNumber(point[axis] - box.low[axis], side);
    }
    const auto number = static_cast<std::uint32_t>(result.size());
    result.push_back(first.emplace(key, number).first->second);
  }
  return result;
}

template <std::size_t N>
void mergeCorners(HtmlMesh::Cells<N>& cells, const std::vector<std::uint32_t>& first)
{
  std::set<std::array<std::uint32_t, N>> seen;
  HtmlMesh::Cells<N> kept;
  for (std::array<std::uint32_t, N> corners : cells)
  {
    for (std::uint32_t& corner : corners)
    {
      corner = first[corner];
    }
    auto sorted = corners;
    std::sort(sorted.begin(), sorted.end());
    const bool whole = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
    if (whole && seen.insert(sorted).second)
    {
      kept.push_back(corners);
    }
  }
  cells = std::move(kept);
}

template <std::size_t N>
void renumber(HtmlMesh::Cells<N>& cells, const std::vector<std::uint32_t>& numbers)
{
  for (auto& corners : cells)
  {
    for (std::uint32_t& corner : corners)
    {
      corner = numbers[corner];
    }
  }
}

template <typename T>
void keep(std::vector<T>& values, const std::vector<std::uint32_t>& which)
{
  std::vector<T> kept;
  kept.reserve(which.size());
  for (const std::uint32_t i : which)
  {
    kept.push_back(values[i]);
  }
  values = std::move(kept);
}

HtmlMesh merged(HtmlMesh mesh, const std::vector<std::uint32_t>& first)
{
  mergeCorners(mesh.triangles, first);
  mergeCorners(mesh.lines, first);
  mergeCorners(mesh.vertices, first);
  std::vector<std::uint32_t> kept;
  std::vector<std::uint32_t> numbers(first.size());
  for (std::uint32_t i = 0; i < first.size(); ++i)
  {
    if (first[i] == i)
    {
      numbers[i] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(i);
    }
  }
  renumber(mesh.triangles, numbers);
  renumber(mesh.lines, numbers);
  renumber(mesh.vertices, numbers);
  keep(mesh.points, kept);
  for (HtmlArray& array : mesh.arrays)
  {
    keep(array.values, kept);
  }
  return mesh;
}

} // namespace

std::size_t HtmlMesh::bytes() const
{
  return points.size() * (3 + arrays.size()) * sizeof(std::uint16_t) +
    (3 * triangles.size() + 2 * lines.size() + vertices.size()) * sizeof(std::uint32_t);
}

HtmlMesh htmlMesh(const TriangleMesh& mesh)
{
  HtmlMesh result;
  result.points = mesh.points;
  result.triangles = cellsOf(mesh.triangles);
  result.lines = cellsOf(mesh.segments);
  for (const int vertex : mesh.vertices)
  {
    result.vertices.push_back({ static_cast<std::uint32_t>(vertex) });
  }
  return result;
}

HtmlMesh htmlMesh(vtkPolyData* axis)
{
  const vtkSmartPointer<vtkPolyData> simple = simpleCells(axis);
  HtmlMesh mesh = withCells(simple);
  mesh.arrays = { arrayOf(simple, "Radius", "Radius", "world units"),
    arrayOf(simple, "SeparationAngle", "Separation angle", "degrees", kAngleScaleEnd),
    arrayOf(simple, "Lambda", "Lambda", "world units") };
  return mesh;
}

HtmlMesh htmlSkeleton(vtkPolyData* skeleton)
{
  if (skeleton == nullptr)
  {
    return {};
  }
  constexpr int kSides = 8;
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(tubesOf(skeleton, kSides));
  vtkNew<vtkPolyData> ends; // with the arrays that the tubes have
  ends->ShallowCopy(skeleton);
  ends->SetLines(nullptr);
  ends->SetVerts(endsOf(skeleton)->GetVerts());
  ends->GetCellData()->Initialize();
  vtkNew<vtkCleanPolyData> used;
  used->SetInputData(ends);
  used->PointMergingOff();
  both->AddInputConnection(used->GetOutputPort());
  both->Update();
  const vtkSmartPointer<vtkPolyData> simple = simpleCells(both->GetOutput());
  HtmlMesh mesh = withCells(simple);
  mesh.arrays = { arrayOf(simple, "Radius", "Radius", "world units") };
  return mesh;
}

void sortByAngle(HtmlMesh& mesh)
{
  const auto angles = std::find_if(mesh.arrays.begin(), mesh.arrays.end(),
    [](const HtmlArray& array) { return array.name == "SeparationAngle"; });
  sortCells(mesh.triangles, angles->values);
  sortCells(mesh.lines, angles->values);
  sortCells(mesh.vertices, angles->values);
}

std::optional<double> coarsen(HtmlMesh& mesh, std::size_t limit)
{
  if (mesh.bytes() <= limit || mesh.points.empty())
  {
    return std::nullopt;
  }
  const Box box = boxOf(mesh.points);
  double boxes = kFinestGrid;
  for (;;)
  {
    const double side = box.longest / boxes;
    HtmlMesh coarse = merged(mesh, firstOfBoxes(mesh.points, box, side));
    if (coarse.bytes() <= limit || boxes < 1.0)
    {
      mesh = std::move(coarse);
      return side;
    }
    // The number of points of a sheet grows with the square of the number of boxes.
    const double share = static_cast<double>(limit) / static_cast<double>(coarse.bytes());
    boxes *= std::min(kCoarser, std::sqrt(share));
  }
}

} // namespace medial::app
