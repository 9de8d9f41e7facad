// Images of solids are read in the physical space of their files, or refused.
#include "labelled_ball.h"

#include "support/files.h"
#include "support/refusal.h"

#include "medial/error.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkXMLImageDataWriter.h>

#include <gtest/gtest.h>

#include <cmath>

namespace medial::test
{
namespace
{

using files::readScan;
using files::Scan;

std::string vtiFile(const LabelImage& image)
{
  vtkNew<vtkImageData> data;
  data->SetExtent(2, image.size[0] + 1, -1, image.size[1] - 2, 0, image.size[2] - 1);
  std::array<double, 3> origin{};
  for (int row = 0; row < 3; ++row)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      data->GetDirectionMatrix()->SetElement(row, axis, image.frame[row][axis] / kImageSteps[axis]);
    }
    origin[row] = image.frame[row][3] - 2.0 * image.frame[row][0] + image.frame[row][1];
  }
  data->SetSpacing(kImageSteps.data());
  data->SetOrigin(origin.data());
  vtkNew<vtkFloatArray> other;
  other->SetName("Gradient");
  other->SetNumberOfComponents(3);
  other->SetNumberOfTuples(static_cast<vtkIdType>(image.values.size()));
  other->Fill(0.0);
  data->GetPointData()->AddArray(other);
  vtkNew<vtkShortArray> labels;
  labels->SetName("Labels");
  for (const std::int16_t value : image.values)
  {
    labels->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(labels);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}

// The labelled ball, in physical space: its steps of up to 1 voxel are smoothed, not moved.
void expectBall(const Scan& scan, const std::string& name)
{
  const auto surface = extractSurface(scan, ofLabel(kLabel), name);
  ASSERT_GT(surface->GetNumberOfPoints(), 500) << name;
  double sum = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double radius = distanceToCentre(surface->GetPoint(i));
    ASSERT_NEAR(radius, kRadius, 0.6) << name;
    sum += radius;
  }
  EXPECT_NEAR(sum / static_cast<double>(surface->GetNumberOfPoints()), kRadius, 0.05) << name;
  EXPECT_NEAR(volumeOf(surface), 4.0 / 3.0 * M_PI * std::pow(kRadius, 3.0), 5.0) << name;
  EXPECT_TRUE(isClosed(surface)) << name;
}

TEST(ScanReader, ReadsEveryFormatInItsPhysicalSpace)
{
  const LabelImage image = ball();
  for (const char* encoding : { "raw", "gzip", "ascii" })
  {
    expectBall(readText("a.nrrd", nrrdFile(image, encoding)), encoding);
  }
  expectBall(readText("a.nrrd", nrrdFile(image, "raw", { "sizes: ", "sizes: +" })), "plus");
  expectBall(readText("a.mha", metaImageFile(image, false, "LOCAL")), "mha");
  expectBall(readText("a.mha", metaImageFile(image, true, "LOCAL")), "compressed mha");
  expectBall(readText("a.nii", niftiFile(image, NiftiSpace::Sform)), "sform");
  expectBall(readText("a.nii", niftiFile(image, NiftiSpace::Qform)), "qform");
  expectBall(readText("a.nii", niftiFile(image, NiftiSpace::Sform, true)), "big endian");
  expectBall(readText("a.NII.gz", deflated(niftiFile(image, NiftiSpace::Qform), true)), "nii.gz");
  expectBall(readText("a.vti", vtiFile(image)), "vti");
}

TEST(ScanReader, TurnsFacesOfMirroredImages)
{
  const LabelImage image = ball(true);
  expectBall(readText("a.nrrd", nrrdFile(image, "raw")), "nrrd");
  expectBall(readText("a.nii", niftiFile(image, NiftiSpace::Sform)), "nii");
}

TEST(ScanReader, ReadsValuesBesideTheirHeader)
{
  const LabelImage image = ball();
  const TemporaryFolder folder;
  writeFile(folder.file("a.mhd"), metaImageFile(image, false, "a.raw"));
  writeFile(folder.file("a.raw"), image.bytes());
  expectBall(readScan(folder.file("a.mhd")), "mhd");
  writeFile(folder.file("a.mhd"), metaImageFile(image, true, "a.zraw"));
  writeFile(folder.file("a.zraw"), deflated(image.bytes(), false));
  expectBall(readScan(folder.file("a.mhd")), "zraw");
  writeFile(folder.file("b.nrrd"),
    nrrdFile(image, "raw", { "encoding: raw", "encoding: raw\ndata file: a.raw\nbyte skip: -1" })
      .substr(0, 400));
  writeFile(folder.file("a.raw"), "17 bytes in front" + image.bytes());
  EXPECT_THROW(readScan(folder.file("b.nrrd")), Error); // its header was cut
  std::string header =
    nrrdFile(image, "raw", { "encoding: raw", "encoding: raw\ndata file: a.raw\nbyte skip: -1" });
  writeFile(folder.file("b.nrrd"), header.substr(0, header.size() - image.bytes().size()));
  expectBall(readScan(folder.file("b.nrrd")), "byte skip");
}

TEST(ScanReader, ScalesValuesOfNifti)
{
  std::string file = niftiFile(ball(), NiftiSpace::Sform);
  const float slope = 0.5F;
  const float intercept = -1.0F;
  file.replace(112, 4, reinterpret_cast<const char*>(&slope), 4);
  file.replace(116, 4, reinterpret_cast<const char*>(&intercept), 4);
  double range[2];
  readText("a.nii", file).image->GetScalarRange(range);
  EXPECT_EQ(range[0], -1.0);
  EXPECT_EQ(range[1], 2.5);
}

TEST(ScanReader, LeavesOutAxesOfOneValue)
{
  const std::string file = nrrdFile(ball(), "raw", { "dimension: 3", "dimension: 4" });
  std::string withAxis = file;
  withAxis.replace(withAxis.find("sizes: "), 7, "sizes: 1 ");
  withAxis.replace(withAxis.find("directions: "), 12, "directions: none ");
  expectBall(readText("a.nrrd", withAxis), "none");
}

std::string refusal(const std::string& name, const std::string& content)
{
  return refusalOf<Error>(
    name, content, [](const std::string& file) { readScan(file); },
    [](const Error& error) { EXPECT_EQ(error.code(), ErrorCode::InvalidInput); });
}

std::string refusedNrrd(const Replacement& replaced, const std::string& encoding = "raw")
{
  return refusal("a.nrrd", nrrdFile(ball(), encoding, replaced));
}

TEST(ScanReader, RefusesDamagedNrrd)
{
  EXPECT_EQ(refusal("a.nrrd", "P5\n"),
    "a.nrrd: is not an NRRD file: it does not start with NRRD000");
  EXPECT_EQ(refusal("a.nrrd", ""), "a.nrrd: the file is empty");
  EXPECT_EQ(refusal("a.nrrd", "NRRD0004\ntype: short\n"),
    "a.nrrd: ends early: its header has no end");
  EXPECT_EQ(refusedNrrd({ "dimension: 3", "dimension: 2" }),
    "a.nrrd: 'dimension' is '2', but there are 3 sizes");
  EXPECT_EQ(refusedNrrd({ "type: short", "type: block" }),
    "a.nrrd: its type is 'block', which is not a type of numbers");
  EXPECT_EQ(refusedNrrd({ "encoding: raw", "encoding: bzip2" }),
    "a.nrrd: its encoding is 'bzip2', allowed: raw, gzip, ascii");
  EXPECT_EQ(refusedNrrd({ "sizes: 30", "sizes: 0" }),
    "a.nrrd: 'sizes' has 0, which is not the size of an axis");
  EXPECT_EQ(refusedNrrd({ "sizes: 30", "sizes: x" }),
    "a.nrrd: 'sizes' has 'x' in place of a number");
  EXPECT_EQ(refusedNrrd({ "sizes: 30 25 12", "sizes: 30 25 120" }),
    "a.nrrd: ends early: its header promises 180000 bytes, and 18000 are there");
  EXPECT_EQ(refusedNrrd({ "sizes: 30 25 12", "sizes: 30000 30000 30000" }),
    "a.nrrd: has no voxels, or more than memory can have");
  EXPECT_TRUE(contains(refusedNrrd({ "sizes: 30 25 12", "sizes: 3000 3000 3000" }, "gzip"),
    "a.nrrd: ends early: its header promises 54000000000 bytes"));
  EXPECT_EQ(refusedNrrd({ "sizes: 30 25 12", "sizes: 30 25 120" }, "gzip"),
    "a.nrrd: ends early: 18000 of 180000 bytes are there");
  EXPECT_EQ(refusedNrrd({ "sizes: 30 25 12", "sizes: 30 25 13" }, "ascii"),
    "a.nrrd: ends early: its header promises 19499 bytes, and 18000 are there");
  EXPECT_EQ(refusedNrrd({ "ID:=ball\n\n", "ID:=ball\n\nx" }, "ascii"),
    "a.nrrd: value 0 is missing, or no number");
  EXPECT_TRUE(contains(refusedNrrd({ "space origin: (", "space origin: (nan," }), "not finite"));
}

// Along three axes without directions.
std::string nrrdWithAxes(const std::string& fields)
{
  return "NRRD0001\ntype: uchar\ndimension: 3\nsizes: 2 4 5\n" + fields + "\nencoding: raw\n\n" +
    std::string(40, '\1');
}

void expectAxes(const std::string& fields, const std::array<double, 3>& steps,
  const std::array<double, 3>& first)
{
  const files::ScanFrame frame = readText("a.nrrd", nrrdWithAxes(fields)).frame;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    EXPECT_DOUBLE_EQ(frame[axis][axis], steps[axis]) << fields;
    EXPECT_DOUBLE_EQ(frame[axis][3], first[axis]) << fields;
  }
}

TEST(ScanReader, PlacesNrrdByTheEndsOfItsAxes)
{
  expectAxes("spacings: 1 2 3", { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 0.0 });
  expectAxes("spacings: 1 2 3\naxis mins: 100 200 300", { 1.0, 2.0, 3.0 }, { 100.5, 201.0, 301.5 });
  expectAxes("spacings: 1 2 3\naxis mins: 100 200 300\ncenters: node cell node", { 1.0, 2.0, 3.0 },
    { 100.0, 201.0, 300.0 });
  expectAxes("axis mins: 0 0 0\naxis maxs: 1 8 -5", { 0.5, 2.0, -1.0 }, { 0.25, 1.0, -0.5 });
  expectAxes("axismins: 7 0 nan\naxismaxs: 8 9 nan\ncenterings: node node node", { 1.0, 3.0, 1.0 },
    { 7.0, 0.0, 0.0 });
}

TEST(ScanReader, RefusesEndsOfAxesThatSayTooLittleOrTooMuch)
{
  EXPECT_EQ(refusal("a.nrrd", nrrdWithAxes("axis maxs: 2 4 5")),
    "a.nrrd: 'axis maxs' has a number for axis 0, but 'axis mins' has none");
  EXPECT_EQ(refusedNrrd({ "endian", "axis mins: 1 2 3\nendian" }),
    "a.nrrd: 'axis mins' and 'space origin' exclude each other");
  EXPECT_EQ(refusal("a.nrrd", nrrdWithAxes("axis mins: 0 0 0\naxis maxs: 0 4 5")),
    "a.nrrd: its axes span no volume, or it is infinitely far away");
}

// Doubles have whole numbers exactly up to 2^53.
TEST(ScanReader, ReadsLargeIntegersOfTextExactly)
{
  const Scan scan = readText("a.nrrd",
    "NRRD0004\ntype: int64\ndimension: 3\nsizes: 3 1 1\nencoding: ascii\n\n"
    "9007199254740993 -9007199254740993 2.0\n");
  const auto* const values = static_cast<const std::int64_t*>(scan.image->GetScalarPointer());
  EXPECT_EQ(values[0], 9007199254740993);
  EXPECT_EQ(values[1], -9007199254740993);
  EXPECT_EQ(values[2], 2);
}

TEST(ScanReader, RefusesSeveralValuesAVoxelAndMoments)
{
  std::string colours = nrrdFile(ball(), "raw", { "dimension: 3", "dimension: 4" });
  colours.replace(colours.find("sizes: 30"), 9, "sizes: 3 10");
  colours.replace(colours.find("directions: "), 12, "directions: none ");
  EXPECT_EQ(refusal("a.nrrd", colours),
    "a.nrrd: has 3 values a voxel or moments (axis 0); one is needed");
  EXPECT_EQ(refusal("a.mha",
              metaImageFile(ball(), false, "LOCAL",
                { "ElementType", "ElementNumberOfChannels = 2\nElementType" })),
    "a.mha: has 2 values a voxel; one is needed");
  EXPECT_EQ(refusal("a.mha",
              metaImageFile(ball(), false, "LOCAL",
                { "NDims = 3", "NDims = 4\nDimSize = 5 5 5 2\nX = 1" })),
    "a.mha: NDims is '4', and DimSize has 3 numbers; three axes are needed");
  std::string series = niftiFile(ball(), NiftiSpace::Sform);
  series[40] = 4;
  series[48] = 6;
  EXPECT_EQ(refusal("a.nii", series), "a.nii: has 6 moments; one is needed");
}

TEST(ScanReader, RefusesDamagedMetaImages)
{
  EXPECT_EQ(refusal("a.mha", "abc\n"), "a.mha: is not a MetaImage: 'abc' is not KEY = VALUE");
  EXPECT_EQ(refusal("a.mha", metaImageFile(ball(), false, "LIST")),
    "a.mha: its values are in several files, which is not supported");
  EXPECT_EQ(refusal("a.mhd", metaImageFile(ball(), false, "absent.raw")),
    "a.mhd: its values are in 'absent.raw', which is not a file");
  EXPECT_EQ(refusal("a.mhd", metaImageFile(ball(), false, "../a.raw")),
    "a.mhd: its values are in '../a.raw', which is outside its folder");
  EXPECT_EQ(
    refusal("a.mha", metaImageFile(ball(), false, "LOCAL", { "MET_SHORT", "MET_SHORT_ARRAY" })),
    "a.mha: its ElementType is 'MET_SHORT_ARRAY', which is not a type of one number");
  EXPECT_EQ(refusal("a.mha",
              metaImageFile(ball(), false, "LOCAL",
                { "ElementSpacing = ", "ElementSpacing = 0 0 0\nX = " })),
    "a.mha: its axes span no volume, or it is infinitely far away");
  std::string damaged = metaImageFile(ball(), true, "LOCAL");
  damaged[damaged.find("LOCAL\n") + 20] ^= 0x55;
  EXPECT_TRUE(contains(refusal("a.mha", damaged), "a.mha: "));
}

TEST(ScanReader, RefusesDamagedNifti)
{
  EXPECT_EQ(refusal("a.nii", "short"),
    "a.nii: is not a NIfTI file with header and values in one (version 1)");
  EXPECT_EQ(refusal("a.nii.gz", "short"), "a.nii.gz: its compressed values are damaged");
  std::string file = niftiFile(ball(), NiftiSpace::Sform);
  EXPECT_EQ(refusal("a.nii", file.substr(0, 4000)),
    "a.nii: ends early: its header promises 18000 bytes, and 3648 are there");
  std::string withoutSpacing = niftiFile(ball(), NiftiSpace::Qform);
  withoutSpacing.replace(84, 4, 4, '\0');
  EXPECT_EQ(refusal("a.nii", withoutSpacing),
    "a.nii: its axis 1 has no spacing (pixdim is 0), and the header no sform");
  file[70] = 99;
  EXPECT_EQ(refusal("a.nii", file),
    "a.nii: its data type is 99, which is not a type of one number");
}

TEST(ScanReader, RefusesDamagedVti)
{
  EXPECT_TRUE(contains(refusal("a.vti", "<VTKFile/>"), "not a VTK file of an image"));
  std::string file = vtiFile(ball());
  file.replace(file.find("NumberOfComponents=\"3\""), 22, "NumberOfComponents=\"2\"");
  EXPECT_NO_THROW(readText("a.vti", file)); // of the array that is not asked for
  const std::size_t whole = file.find("WholeExtent=\"2 31");
  file.replace(whole, 17, "WholeExtent=\"2 32");
  EXPECT_EQ(refusal("a.vti", file), "a.vti: has no piece with the whole image");
}

} // namespace
} // namespace medial::test
