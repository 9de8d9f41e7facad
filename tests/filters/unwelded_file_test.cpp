#include "filters/filter_support.h"
#include "support/mesh_search.h"
#include "support/models.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLPolyDataWriter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

// Surfaces from VTK's own files, every triangle with points of its own.
namespace medial::test
{
namespace
{

vtkSmartPointer<vtkPolyData> unweldedCopy(vtkPolyData* surface)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    triangles->InsertNextCell(3);
    for (vtkIdType i = 0; i < 3; ++i)
    {
      const vtkIdType corner = surface->GetCell(cell)->GetPointId(static_cast<int>(i));
      triangles->InsertCellPoint(points->InsertNextPoint(surface->GetPoint(corner)));
    }
  }
  result->SetPoints(points);
  result->SetPolys(triangles);
  return result;
}

vtkSmartPointer<vtkPolyData> read(const std::string& path)
{
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkTriangleFilter> triangles; // the bunny has vertex cells too
  triangles->PassVertsOff();
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->Update();
  return triangles->GetOutput();
}

TriangleMesh meshOf(vtkPolyData* surface)
{
  MeshInput input;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    Point3 point;
    surface->GetPoint(i, point.data());
    input.points.push_back(point);
  }
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    vtkCell* triangle = surface->GetCell(cell);
    input.polygons.append(
      { triangle->GetPointId(0), triangle->GetPointId(1), triangle->GetPointId(2) }, cell);
  }
  return buildTriangleMesh(input);
}

void expectExactAndSigned(vtkPolyData* surface, int resolution)
{
  const TriangleMesh mesh = meshOf(surface);
  vtkNew<vtkMeshDistanceField> filter;
  filter->SetInputData(surface);
  filter->SetResolution(resolution);
  filter->Update();
  ASSERT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(figure(filter->GetOutput(), "Closed"), 1.0) << "welding has to close the surface";
  vtkImageData* image = filter->GetOutput();
  const MeshSearch search(mesh);
  const vtkIdType stride = 1 + image->GetNumberOfPoints() / 5000;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); i += stride)
  {
    Point3 x;
    image->GetPoint(i, x.data());
    const double truth = search.closest(x).distance;
    ASSERT_NEAR(std::abs(valueOf(image, "Distance", i)), truth, 1e-3 * image->GetSpacing()[0]);
  }
}

TEST(UnweldedFile, OfAGeneratedSurfaceIsExact)
{
  const std::string path =
    (std::filesystem::path(testing::TempDir()) / "medial_unwelded.vtp").string();
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(unweldedCopy(lumpPolyData()));
  writer->SetFileName(path.c_str());
  ASSERT_EQ(writer->Write(), 1);
  expectExactAndSigned(read(path), 48);
  std::filesystem::remove(path);
}

class UnweldedModel : public testing::TestWithParam<int>
{
};

TEST_P(UnweldedModel, IsExact)
{
  expectExactAndSigned(read(*modelPath("paper/bunny_vtk_1k_unwelded.vtp")), GetParam());
}

std::vector<int> resolutionsIfFound()
{
  return modelPath("paper/bunny_vtk_1k_unwelded.vtp") ? std::vector<int>{ 64, 256 }
                                                      : std::vector<int>{};
}

INSTANTIATE_TEST_SUITE_P(Resolution, UnweldedModel, testing::ValuesIn(resolutionsIfFound()));
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(UnweldedModel);

} // namespace
} // namespace medial::test
