// Outputs that would replace an input, or a file of each other.
#include "command_run.h"

#include "failure.h"
#include "output/output_names.h"

#include "support/shapes.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

namespace fs = std::filesystem;

using app::checkNames;
using app::NamedInput;
using app::NamedOutput;

/// What is said against the names; nothing if they are good.
std::string refusal(const std::vector<NamedOutput>& outputs, const std::vector<NamedInput>& inputs)
{
  try
  {
    checkNames(outputs, inputs);
  }
  catch (const app::Failure& failure)
  {
    EXPECT_EQ(failure.exitCode(), app::ExitCode::Usage);
    return failure.what();
  }
  return "";
}

TEST(OutputNames, PiecesAreNamedByTheirIndex)
{
  EXPECT_EQ(app::pieceOf("d/a.pvtp", 0), "d/a_0.vtp");
  EXPECT_EQ(app::pieceOf("a.b.PVTI", 12), "a.b_12.vti");
  EXPECT_EQ(app::pieceOf("a.pvd", 3), "a_3.vtp");
  EXPECT_FALSE(app::piecesOf("a.vtp"));
  EXPECT_EQ(app::picturesIn("d").file(7), "d/frame_0007.png");
  EXPECT_EQ(app::picturesIn("d").file(12345), "d/frame_12345.png");
}

TEST(OutputNames, APieceIsNoInput)
{
  const auto against = [](const fs::path& index, const fs::path& input) {
    return refusal({ { "-o", index } }, { { input, { input } } });
  };
  EXPECT_EQ(against("m.pvtp", "m_0.vtp"), "-o m.pvtp: its piece m_0.vtp is the input file itself");
  EXPECT_NE(against("m.pvtp", "m_17.vtp"), "");
  EXPECT_NE(against("./m.pvtp", fs::current_path() / "m_0.vtp"), "");
  EXPECT_NE(against("m.pvti", "m_0.vti"), "");
  EXPECT_NE(against("m.pvd", "m_0.vtp"), "");
  for (const char* other : { "m_.vtp", "m_00.vtp", "m_0.vti", "m_0.VTP", "m_0_0.vtp", "am_0.vtp",
         "m_x.vtp", "d/m_0.vtp", "m_99999999999999999999999.vtp" })
  {
    EXPECT_EQ(against("m.pvtp", other), "") << other;
  }
  EXPECT_EQ(against("m.vtp", "m_0.vtp"), "");
}

TEST(OutputNames, AFileThatAnInputNamesIsKept)
{
  const std::vector<NamedInput> scan{ { "a.nrrd", { "a.nrrd", "d/values_1.vti" } } };
  EXPECT_EQ(refusal({ { "--field", "d/values_1.vti" } }, scan),
    "--field d/values_1.vti is a file of the input a.nrrd");
  EXPECT_EQ(refusal({ { "--field", "d/values.pvti" } }, scan),
    "--field d/values.pvti: its piece d/values_1.vti is a file of the input a.nrrd");
  EXPECT_EQ(refusal({ { "--field", "values_1.vti" }, { "--report", "-" }, { "-o", "" } }, scan),
    "");
}

TEST(OutputNames, OutputsHaveNoFileInCommon)
{
  const auto of = [](const NamedOutput& a, const NamedOutput& b) { return refusal({ a, b }, {}); };
  const auto expectShared = [&](const NamedOutput& a, const NamedOutput& b, const fs::path& file)
  {
    EXPECT_EQ(of(a, b), "--a and --b name the same file, " + file.string());
    EXPECT_EQ(of(b, a), "--b and --a name the same file, " + file.string());
  };
  expectShared({ "--a", "x.pvtp" }, { "--b", "x_0.vtp" }, "x_0.vtp");
  expectShared({ "--a", "x.pvtp" }, { "--b", "x.PVTP" }, "x_0.vtp");
  expectShared({ "--a", "f.pvti" }, { "--b", "f_5.vti" }, "f_5.vti");
  expectShared({ "--a", "d", app::picturesIn("d") }, { "--b", "d/frame_0003.png" },
    "d/frame_0003.png");
  EXPECT_EQ(of({ "--a", "x.pvtp" }, { "--b", "x.pvti" }), "");
  EXPECT_EQ(of({ "--a", "x.pvtp" }, { "--b", "x_0.pvtp" }), "");
  EXPECT_EQ(of({ "--a", "d", app::picturesIn("d") }, { "--b", "d/frame_3.png" }), "");
  EXPECT_EQ(of({ "--a", "-" }, { "--b", "-" }), "");
  EXPECT_EQ(of({ "--a", "" }, { "--b", "" }), "");
}

TEST(OutputNames, OneFileHasManySpellings)
{
  TemporaryFolder folder;
  fs::create_directory(folder.path() / "real");
  fs::create_directory_symlink("real", folder.path() / "link");
  const fs::path place = fs::current_path();
  fs::current_path(folder.path() / "real");
  const std::string above = folder.path().filename().string();
  for (const fs::path& spelling :
    { fs::path("./x.vtp"), folder.path() / "real/x.vtp", fs::path("../real/x.vtp"),
      fs::path("../link/x.vtp"), fs::path("../../" + above) / "link/./x.vtp" })
  {
    EXPECT_NE(refusal({ { "--a", "x.vtp" }, { "--b", spelling } }, {}), "") << spelling;
  }
  EXPECT_NE(refusal({ { "--a", "x.pvtp" }, { "--b", "../link/x_1.vtp" } }, {}), "");
  EXPECT_EQ(refusal({ { "--a", "x.vtp" }, { "--b", "../x.vtp" } }, {}), "");
  fs::current_path(place);
}

TEST(OutputNames, APieceThatIsALinkStandsForWhatItLeadsTo)
{
  TemporaryFolder folder;
  writeFile(folder.file("mesh.vtp"), "a mesh");
  fs::create_symlink("mesh.vtp", folder.path() / "m_3.vtp");
  const fs::path mesh = folder.file("mesh.vtp");
  EXPECT_TRUE(contains(refusal({ { "-o", folder.file("m.pvtp") } }, { { mesh, { mesh } } }),
    "m_3.vtp is the input file itself"));
}

class OutputNamesRun : public CommandRun
{
protected:
  OutputNamesRun()
    : CommandRun(box({ 1, 1, 1 }))
  {
    options.folder = folder.path();
  }

  /// A run that is refused, and changes nothing.
  void expectRefusal(Outcome (*program)(const std::vector<std::string>&, const RunOptions&),
    const std::vector<std::string>& arguments, const std::string& message) const
  {
    const auto contents = [&]
    {
      std::vector<std::string> files = folder.list();
      std::transform(files.begin(), files.end(), files.begin(),
        [&](const std::string& name) { return name + readFile(folder.file(name)); });
      return files;
    };
    const auto before = contents();
    const Outcome outcome = program(arguments, options);
    EXPECT_EQ(outcome.exitCode, kUsage);
    EXPECT_TRUE(contains(outcome.err, message)) << outcome.err;
    EXPECT_TRUE(contents() == before);
  }

  RunOptions options;
};

TEST_F(OutputNamesRun, APieceDoesNotReplaceAScan)
{
  run({ "--resolution", "24", "--field", folder.file("f_0.vti") });
  expectRefusal(runMedialAxis, { "f_0.vti", "--isovalue", "0", "--field", "f.pvti" },
    "--field f.pvti: its piece f_0.vti is the input file itself");
}

TEST_F(OutputNamesRun, NoOutputReplacesTheValuesOfAScan)
{
  const std::string sizes = "DimSize = 2 2 2\nElementType = MET_UCHAR\n";
  writeFile(folder.file("a.mhd"),
    "ObjectType = Image\nNDims = 3\n" + sizes + "ElementDataFile = values.vti\n");
  writeFile(folder.file("a.nrrd"),
    "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: values.vti\n\n");
  writeFile(folder.file("values.vti"), std::string("\0\1\2\3\4\5\6\7", 8));
  for (const std::string header : { "a.mhd", "a.nrrd" })
  {
    expectRefusal(runMedialAxis, { header, "--isovalue", "3", "--field", "values.vti" },
      "--field values.vti is a file of the input " + header);
  }
}

TEST_F(OutputNamesRun, OutputsDoNotReplaceEachOther)
{
  expectRefusal(runMedialAxis, { "box.obj", "--field", "f.pvti", "--local-thickness", "f_0.vti" },
    "--field and --local-thickness name the same file, f_0.vti");
  expectRefusal(runMedialAxis, { "box.obj", "-o", "x.vtp", "--curves", "./x.vtp" },
    "--output and --curves name the same file, x.vtp");
  expectRefusal(runMedialAxis, { "box.obj", "-o", "x.vtp", "--thickness", folder.file("x.vtp") },
    "--output and --thickness name the same file, x.vtp");
  expectRefusal(runMedialProximity,
    { "box.obj", "box.obj", "--animation", "d", "--image", "d/frame_0000.png" },
    "--image and --animation name the same file, d/frame_0000.png");
}

TEST_F(OutputNamesRun, ContactsDoNotReplaceAMesh)
{
  run({ "--thickness", folder.file("c_0.vtp") });
  expectRefusal(runMedialProximity, { "c_0.vtp", "box.obj", "--contacts", "c.pvd" },
    "--contacts c.pvd: its piece c_0.vtp is the input file itself");
  fs::create_directory(folder.path() / "frames");
  fs::rename(folder.file("c_0.vtp"), folder.path() / "frames/c_0.vtp");
  const std::vector<std::string> names = folder.list();
  const Outcome outcome = runMedialProximity(
    { "box.obj", "frames", "--sequence", "--contacts", "frames/c_0.vtp" }, options);
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_TRUE(contains(outcome.err, "frames/c_0.vtp is a file of the input frames")) << outcome.err;
}

TEST_F(OutputNamesRun, NoOutputReplacesATransform)
{
  writeFile(folder.file("m.json"), "1 0 0 3 0 1 0 0 0 0 1 0\n");
  expectRefusal(runMedialProximity,
    { "box.obj", "box.obj", "--transform", "1=m.json", "--json", "m.json" },
    "--json m.json is the input file itself");
}

} // namespace
} // namespace medial::test
