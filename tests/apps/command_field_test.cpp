#include "command_run.h"
#include "input/surface_reader.h"

#include "support/models.h"
#include "support/shapes.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataReader.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>

namespace medial::test
{
namespace
{

using Image = vtkSmartPointer<vtkImageData>;
using Settings = std::function<void(vtkMeshDistanceField*)>;

Image readField(const std::string& path)
{
  return path.find(".pvti") != std::string::npos ? readWith<vtkXMLPImageDataReader>(path)
                                                 : readWith<vtkXMLImageDataReader>(path);
}

void expectSameArray(vtkDataArray* actual, vtkDataArray* expected)
{
  ASSERT_NE(actual, nullptr);
  EXPECT_STREQ(actual->GetName(), expected->GetName());
  EXPECT_STREQ(actual->GetClassName(), expected->GetClassName());
  ASSERT_EQ(actual->GetNumberOfComponents(), expected->GetNumberOfComponents());
  ASSERT_EQ(actual->GetNumberOfTuples(), expected->GetNumberOfTuples());
  const auto bytes = static_cast<std::size_t>(actual->GetNumberOfValues()) *
    static_cast<std::size_t>(actual->GetDataTypeSize());
  EXPECT_EQ(std::memcmp(actual->GetVoidPointer(0), expected->GetVoidPointer(0), bytes), 0)
    << expected->GetName();
}

void expectSameImage(vtkImageData* actual, vtkImageData* expected)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(actual->GetOrigin()[axis], expected->GetOrigin()[axis]);
    EXPECT_EQ(actual->GetSpacing()[axis], expected->GetSpacing()[axis]);
    EXPECT_EQ(actual->GetExtent()[2 * axis], expected->GetExtent()[2 * axis]);
    EXPECT_EQ(actual->GetExtent()[2 * axis + 1], expected->GetExtent()[2 * axis + 1]);
  }
  vtkPointData* data = actual->GetPointData();
  ASSERT_EQ(data->GetNumberOfArrays(), expected->GetPointData()->GetNumberOfArrays());
  ASSERT_NE(data->GetScalars(), nullptr);
  EXPECT_STREQ(data->GetScalars()->GetName(), "Distance");
  EXPECT_EQ(actual->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(actual->GetFieldData()->GetNumberOfArrays(), 0);
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    expectSameArray(data->GetArray(i), expected->GetPointData()->GetArray(i));
  }
}

// Up to a thousandth of a voxel; closest points at their distance.
void expectSameDistances(vtkImageData* actual, vtkImageData* expected)
{
  ASSERT_EQ(actual->GetNumberOfPoints(), expected->GetNumberOfPoints());
  const double tolerance = 1e-3 * expected->GetSpacing()[0];
  vtkDataArray* closest = actual->GetPointData()->GetArray("ClosestPoint");
  for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
  {
    const double distance = actual->GetPointData()->GetScalars()->GetTuple1(i);
    ASSERT_NEAR(distance, expected->GetPointData()->GetScalars()->GetTuple1(i), tolerance);
    double point[3];
    actual->GetPoint(i, point);
    const double* nearest = closest->GetTuple3(i);
    ASSERT_NEAR(std::hypot(nearest[0] - point[0], nearest[1] - point[1], nearest[2] - point[2]),
      std::abs(distance), tolerance);
  }
}

class CommandField : public CommandRun
{
protected:
  CommandField()
    : CommandRun(box({ 1.0, 0.7, 0.4 }), "mesh.obj")
  {
  }

  // The field as the filter makes it.
  Image filterField(const Settings& settings)
  {
    vtkNew<vtkMeshDistanceField> filter;
    filter->SetInputData(app::readSurface(input).polyData());
    settings(filter);
    filter->Update();
    return filter->GetOutput();
  }

  // Writes the field as one file and in pieces, and compares both with the filter's.
  void expectFilterField(const TriangleMesh& mesh, const std::vector<std::string>& arguments,
    const Settings& settings)
  {
    writeFile(input, objText(mesh));
    const Image expected = filterField(settings);
    for (const std::string& name : { folder.file("field.vti"), folder.file("field.pvti") })
    {
      std::vector<std::string> words = arguments;
      words.insert(words.end(), { "--field", name, "--quiet" });
      run(words);
      expectSameImage(readField(name), expected);
    }
  }
};

TEST_F(CommandField, OfAClosedMeshIsTheFilters)
{
  expectFilterField(torus(1.0, 0.35, 24, 12), { "--resolution", "77" },
    [](auto* filter) { filter->SetResolution(77); });
  EXPECT_LT(readField(folder.file("field.vti"))->GetScalarRange()[0], 0.0);
}

TEST_F(CommandField, OfATallMeshHasSeveralPieces)
{
  expectFilterField(uvCapsule(0.2, 1.5, 12), { "--resolution", "203", "--padding", "0" },
    [](auto* filter)
    {
      filter->SetResolution(203);
      filter->SetPadding(0.0);
    });
  EXPECT_EQ(folder.list(),
    (std::vector<std::string>{ "field.pvti", "field.vti", "field_0.vti", "field_1.vti",
      "field_2.vti", "field_3.vti", "mesh.obj" }));
}

TEST_F(CommandField, OfASoupIsTheFilters)
{
  expectFilterField(randomSoup(50, 7), { "--spacing", "0.031" },
    [](auto* filter)
    {
      filter->SetGridModeToSpacing();
      filter->SetSpacing(0.031, 0.031, 0.031);
    });
  EXPECT_GE(readField(folder.file("field.vti"))->GetScalarRange()[0], 0.0);
}

TEST_F(CommandField, UnsignedIsTheFilters)
{
  expectFilterField(torus(1.0, 0.35, 24, 12), { "--resolution", "50", "--sign", "none" },
    [](auto* filter)
    {
      filter->SetResolution(50);
      filter->SetSignMethodToNone();
    });
}

TEST_F(CommandField, OfTheRasteriserIsTheFilters)
{
  expectFilterField(torus(1.0, 0.35, 24, 12), { "--resolution", "64", "--engine", "rasteriser" },
    [](auto* filter)
    {
      filter->SetResolution(64);
      filter->SetEngineToRasteriser();
    });
}

// In six slabs or more, of four slices. Between sites at equal distance the choice depends on the
// slabs.
TEST_F(CommandField, InManySlabsIsTheFilters)
{
  TriangleMesh thin = torus(1.0, 0.2, 24, 12);
  for (Point3& point : thin.points)
  {
    point[2] *= 0.05;
  }
  writeFile(input, objText(thin));
  const Image expected = filterField(
    [](auto* filter)
    {
      filter->SetResolution(600);
      filter->SetPadding(0.01);
    });
  ASSERT_GT(expected->GetDimensions()[2], 20);
  for (const std::string& name : { folder.file("field.vti"), folder.file("field.pvti") })
  {
    run({ "--resolution", "600", "--padding", "0.01", "--memory", "64", "--field", name });
    expectSameDistances(readField(name), expected);
  }
}

TEST_F(CommandField, BesideAnAxisHasTheSameDistances)
{
  writeFile(input, objText(torus(1.0, 0.35, 24, 12)));
  run({ "--resolution", "60", "--field", folder.file("alone.vti") });
  run({ "--resolution", "60", "--field", folder.file("beside.vti"), "-o", folder.file("a.vtp") });
  const Image alone = readField(folder.file("alone.vti"));
  const Image beside = readField(folder.file("beside.vti"));
  EXPECT_EQ(beside->GetPointData()->GetNumberOfArrays(), 5);
  expectSameDistances(beside, alone);
}

TEST_F(CommandField, OfARealMeshIsTheFilters)
{
  const auto model = modelPath("paper/triceratops.off");
  const TriangleMesh mesh =
    model ? buildTriangleMesh(loadModel(*model)) : torus(1.0, 0.35, 100, 50);
  expectFilterField(mesh, { "--resolution", "130" },
    [](auto* filter) { filter->SetResolution(130); });
}

TEST_F(CommandField, AloneComputesNoAxis)
{
  writeFile(input, objText(box({ 1.0, 0.7, 0.4 })));
  const Outcome outcome = run({ "--resolution", "41", "--side", "exterior", "--field",
    folder.file("f.vti"), "--report", folder.file("r.json") });
  EXPECT_EQ(outcome.err, "");
  const Json report = Json::parse(readFile(folder.file("r.json")));
  EXPECT_EQ(report["counts"]["medial_points"], 0);
  EXPECT_EQ(report["counts"]["medial_cells"], 0);
  EXPECT_EQ(report["counts"]["sites"], 12 + 18 + 8);
  EXPECT_EQ(report["sign_method"], "winding");
  EXPECT_EQ(report["seconds"]["medial"], 0.0);
  EXPECT_GT(report["seconds"]["write"].get<double>(), 0.0);
  EXPECT_GE(report["fragments_per_voxel"].get<double>(), 1.0);
}

TEST_F(CommandField, PiecesAreFoundWhateverTheirName)
{
  writeFile(input, objText(uvCapsule(0.2, 1.5, 8)));
  const std::string name = folder.file("a & \"b\" <1>.d.pvti");
  run({ "--resolution", "80", "--field", name });
  EXPECT_EQ(readField(name)->GetDimensions()[2], 80);
}

TEST_F(CommandField, ReplacesOlderFiles)
{
  writeFile(input, objText(uvCapsule(0.2, 1.5, 8)));
  for (const char* old : { "f.pvti", "f_0.vti", "f_1.vti" })
  {
    writeFile(folder.file(old), "old");
  }
  run({ "--resolution", "80", "--field", folder.file("f.pvti") });
  EXPECT_EQ(readField(folder.file("f.pvti"))->GetDimensions()[2], 80);
  EXPECT_EQ(folder.list(),
    (std::vector<std::string>{ "f.pvti", "f_0.vti", "f_1.vti", "mesh.obj" }));
}

TEST_F(CommandField, ArraysThatAreNotWantedTakeNoSpace)
{
  const auto size = [&](const std::string& name)
  { return static_cast<std::int64_t>(std::filesystem::file_size(folder.file(name))); };
  const std::string all = folder.file("all.vti");
  run({ "--resolution", "40", "--field", all });
  run({ "--resolution", "40", "--field", folder.file("one.vti"), "--field-arrays", "distance" });
  run({ "--resolution", "40", "--field", folder.file("two.vti"), "--field-arrays",
    "closest_site,closest_point", "-o", folder.file("axis.vtp") });
  run({ "--resolution", "40", "--field", folder.file("one.pvti"), "--field-arrays", "distance" });
  const Image full = readField(all);
  const std::int64_t points = full->GetNumberOfPoints();
  // Headers differ by what they say of the arrays.
  EXPECT_NEAR(static_cast<double>(size("all.vti") - size("one.vti")), 25.0 * points, 1000.0);
  EXPECT_NEAR(static_cast<double>(size("all.vti") - size("two.vti")), 9.0 * points, 1000.0);
  for (const char* name : { "one.vti", "one.pvti" })
  {
    const Image one = readField(folder.file(name));
    EXPECT_EQ(one->GetPointData()->GetNumberOfArrays(), 1) << name;
    expectSameArray(one->GetPointData()->GetArray(0), full->GetPointData()->GetArray("Distance"));
  }
  const Image two = readField(folder.file("two.vti"));
  EXPECT_EQ(two->GetPointData()->GetNumberOfArrays(), 3);
  for (const char* name : { "Distance", "ClosestPoint", "ClosestSite" })
  {
    expectSameArray(two->GetPointData()->GetArray(name), full->GetPointData()->GetArray(name));
  }
}

} // namespace
} // namespace medial::test
