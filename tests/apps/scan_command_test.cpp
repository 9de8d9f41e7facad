// medial-axis on scans, and its fields as volumes.
#include "command_run.h"
#include "scan_files.h"

#include "files/scans/scan_reader.h"

#include "support/shapes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

namespace medial::test
{
namespace
{

class ScanCommand : public CommandRun
{
protected:
  ScanCommand()
    : CommandRun(icosphere(4.0, 3))
  {
    const LabelImage image([](double r) { return r < 4.0 ? 2 : 0; });
    writeFile(folder.file("ball.nrrd"), nrrdFile(image, "gzip"));
  }

  // A run that is refused, and leaves nothing.
  void expectRefusal(const std::vector<std::string>& arguments, int exitCode,
    const std::string& message) const
  {
    RunOptions options;
    options.folder = folder.path();
    const auto before = folder.list();
    const Outcome outcome = runMedialAxis(arguments, options);
    EXPECT_EQ(outcome.exitCode, exitCode);
    EXPECT_TRUE(contains(outcome.err, message)) << outcome.err;
    EXPECT_EQ(folder.list(), before);
  }
};

TEST_F(ScanCommand, ComputesTheAxisOfALabel)
{
  input = folder.file("ball.nrrd");
  run({ "--label", "2", "--resolution", "48", "-o", folder.file("axis.vtp") });
  const auto axis = readVtp(folder.file("axis.vtp"));
  ASSERT_GT(axis->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < axis->GetNumberOfPoints(); ++i)
  {
    const double* p = axis->GetPoint(i);
    const double off =
      std::hypot(p[0] - kImageCentre[0], p[1] - kImageCentre[1], p[2] - kImageCentre[2]);
    const double radius = axis->GetPointData()->GetArray("Radius")->GetComponent(i, 0);
    ASSERT_NEAR(off + radius, 4.0, 0.6); // medial balls touch the surface of the ball
  }
}

TEST_F(ScanCommand, NamesItsOutputByTheScan)
{
  std::filesystem::rename(folder.file("ball.nrrd"), folder.file("x.nrrd"));
  const LabelImage image([](double r) { return r < 4.0 ? 2 : 0; });
  writeFile(folder.file("ball.nii.gz"), deflated(niftiFile(image, NiftiSpace::Qform), true));
  RunOptions options;
  options.folder = folder.path();
  const Outcome outcome =
    runMedialAxis({ "ball.nii.gz", "--label", "2", "--resolution", "24", "-q" }, options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(folder.file("ball_medial.vtp")));
}

TEST_F(ScanCommand, RefusesScansAndMeshesThatDoNotFitTheirOptions)
{
  expectRefusal({ "ball.nrrd", "-o", "a.vtp" }, 2,
    "ball.nrrd is an image: choose its surface with --isovalue V or --label N");
  expectRefusal({ "ball.nrrd", "--label", "1", "--isovalue", "1", "-o", "a.vtp" }, 2,
    "--isovalue 1 cannot be given together with --label 1");
  expectRefusal({ "box.obj", "--label", "1", "-o", "a.vtp" }, 2, "--label needs an image");
  expectRefusal({ "box.obj", "--isovalue", "1", "-o", "a.vtp" }, 2, "--isovalue needs an image");
  expectRefusal({ "box.obj", "--scan-smoothing", "1", "-o", "a.vtp" }, 2,
    "--scan-smoothing needs an image");
  expectRefusal({ "ball.nrrd", "--label", "2", "--field", "ball.nrrd" }, 2,
    "is the input file itself");
  expectRefusal({ "ball.nrrd", "--label", "5", "-o", "a.vtp" }, 3, "those that occur: 0, 2");
  expectRefusal({ "ball.nrrd", "--label", "2.5", "-o", "a.vtp" }, 2,
    "--label: 2.5 is not a whole number; allowed: [-9223372036854775808, 9223372036854775807]");
  expectRefusal({ "ball.nrrd", "--label", "99999999999999999999", "-o", "a.vtp" }, 2,
    "--label: 99999999999999999999 is outside [-9223372036854775808, 9223372036854775807]");
  expectRefusal({ "ball.nrrd", "--label=-9223372036854775809", "-o", "a.vtp" }, 2,
    "--label: -9223372036854775809 is outside [-9223372036854775808, 9223372036854775807]");
  expectRefusal({ "ball.nrrd", "--isovalue", "5", "-o", "a.vtp" }, 3, "its values are in [0, 2]");
  expectRefusal({ "box.obj", "--field", "f.nrrd", "--field-arrays", "closest_cell" }, 2,
    "f.nrrd holds the distance alone");
}

// The same distances at the same places in every format.
TEST_F(ScanCommand, FieldsGoToVolumes)
{
  std::vector<files::Scan> fields;
  for (const char* name : { "field.vti", "field.nrrd", "field.mha", "field.nii.gz" })
  {
    // Several slabs, so that values come in parts.
    run({ "--field", folder.file(name), "--resolution", "120", "--memory", "64" });
    fields.push_back(files::readScan(folder.file(name)));
  }
  const files::Scan& first = fields.front();
  vtkDataArray* expected = first.image->GetPointData()->GetScalars();
  for (std::size_t k = 1; k < fields.size(); ++k)
  {
    vtkDataArray* values = fields[k].image->GetPointData()->GetScalars();
    ASSERT_EQ(values->GetNumberOfTuples(), expected->GetNumberOfTuples());
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      ASSERT_EQ(values->GetComponent(i, 0), expected->GetComponent(i, 0)) << k;
    }
    for (std::size_t row = 0; row < 3; ++row)
    {
      for (std::size_t axis = 0; axis < 4; ++axis)
      {
        EXPECT_NEAR(fields[k].frame[row][axis], first.frame[row][axis], 1e-6) << k; // NIfTI: floats
      }
    }
  }
}

TEST_F(ScanCommand, BandsAreOfVdbFiles)
{
  expectRefusal({ "box.obj", "--field", "f.mha", "--band", "4" }, 2,
    "--band needs --field FILE.vdb");
  expectRefusal({ "box.obj", "--field", "f.vdb", "--band", "0" }, 2, "0 is outside [1, 1000]");
#ifndef MEDIAL_VDB
  expectRefusal({ "box.obj", "--field", "f.vdb" }, 2, "f.vdb: this build is without OpenVDB");
#endif
}

// A signed distance is a grey image with the solid below 0.
TEST_F(ScanCommand, TheSurfaceOfAFieldIsTheMesh)
{
  run({ "--field", folder.file("field.mha"), "--resolution", "64" });
  input = folder.file("field.mha");
  run({ "--isovalue", "0", "--resolution", "32", "--thickness", folder.file("surface.vtp") });
  const auto surface = readVtp(folder.file("surface.vtp"));
  ASSERT_GT(surface->GetNumberOfPoints(), 1000);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    ASSERT_NEAR(std::hypot(p[0], p[1], p[2]), 4.0, 0.05);
  }
}

} // namespace
} // namespace medial::test
