#include "methods/field_method.h"
#include "methods/grid_blocks.h"
#include "methods/vtk_mesh.h"

#include "base/stopwatch.h"

#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <vtkImplicitPolyDataDistance.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkVersion.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <random>

namespace medial::benchmark
{
namespace
{

/// One row of grid points in so many is evaluated.
constexpr int kRowsPerSample = 64;

using Row = std::array<int, 2>; ///< j, k

/// A random share of the rows along x; at least one.
std::vector<Row> sampledRows(const Grid& grid)
{
  std::vector<Row> rows;
  for (int k = 0; k < grid.dimensions[2]; ++k)
  {
    for (int j = 0; j < grid.dimensions[1]; ++j)
    {
      rows.push_back({ j, k });
    }
  }
  std::mt19937 random(1);
  std::shuffle(rows.begin(), rows.end(), random);
  rows.resize(std::max<std::size_t>(rows.size() / kRowsPerSample, 1));
  std::sort(rows.begin(), rows.end(),
    [](const Row& a, const Row& b) { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; });
  return rows;
}

/// Calls body(thread) once for each of so many threads at the same time.
template <class Body>
void onEachThread(int threads, Body&& body)
{
  tbb::task_group group;
  for (int thread = 0; thread < threads; ++thread)
  {
    group.run([&body, thread] { body(thread); });
  }
  group.wait();
}

class VtkMethod final : public FieldMethod
{
public:
  std::string name() const override
  {
    return "VTK " + std::to_string(VTK_MAJOR_VERSION) + "." + std::to_string(VTK_MINOR_VERSION) +
      ", sampled";
  }

  FieldResult compute(const TriangleMesh& mesh, const Grid& grid) override
  {
    FieldResult result;
    result.distance.assign(static_cast<std::size_t>(grid.pointCount()),
      std::numeric_limits<float>::quiet_NaN());
    const int threads = tbb::this_task_arena::max_concurrency();
    std::vector<vtkSmartPointer<vtkImplicitPolyDataDistance>> functions(
      static_cast<std::size_t>(threads));
    double build = 0.0;
    // Locators are not safe for threads, so each thread has its own.
    timed(build,
      [&]
      {
        onEachThread(threads,
          [&](int thread)
          {
            functions[thread] = vtkSmartPointer<vtkImplicitPolyDataDistance>::New();
            functions[thread]->SetInput(makePolyData(mesh));
          });
      });
    double query = 0.0;
    const std::vector<Row> rows = sampledRows(grid);
    timed(query,
      [&]
      {
        std::atomic<std::size_t> next{ 0 };
        onEachThread(threads,
          [&](int thread)
          {
            for (std::size_t row = next++; row < rows.size(); row = next++)
            {
              this->evaluateRow(*functions[thread], grid, rows[row], result);
            }
          });
      });
    const double allRows = static_cast<double>(grid.dimensions[1]) * grid.dimensions[2];
    result.seconds = { { "build", build },
      { "query", query * allRows / static_cast<double>(rows.size()) } };
    result.figures = { { "evaluated_share", static_cast<double>(rows.size()) / allRows } };
    return result;
  }

private:
  static void evaluateRow(vtkImplicitPolyDataDistance& function, const Grid& grid, const Row& row,
    FieldResult& result)
  {
    for (int i = 0; i < grid.dimensions[0]; ++i)
    {
      Point3 point = grid.point(i, row[0], row[1]);
      const double distance = function.EvaluateFunction(point.data());
      result.distance[pointIndex(grid, i, row[0], row[1])] = static_cast<float>(std::abs(distance));
    }
  }
};

} // namespace

std::unique_ptr<FieldMethod> makeVtkMethod()
{
  return std::make_unique<VtkMethod>();
}

} // namespace medial::benchmark
