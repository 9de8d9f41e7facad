#include "program.h"
#include "support/mesh_texts.h"

#include "support/shapes.h"

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <tuple>

namespace medial::test
{
namespace
{

class CommandFailure : public ::testing::Test
{
protected:
  CommandFailure() { writeFile(input, objText(box({ 1.0, 0.7, 0.4 }))); }

  // Runs with all outputs, and must end with `exitCode`, one line on stderr and no file.
  std::string failure(int exitCode, std::vector<std::string> arguments,
    const RunOptions& options = {})
  {
    const TemporaryFolder outputs;
    arguments.insert(arguments.end(),
      { "-o", outputs.file("axis.vtp"), "--field", outputs.file("field.vti"), "--image",
        outputs.file("picture.png"), "--curves", outputs.file("curves.vtp"), "--report",
        outputs.file("report.json"), "--thickness", outputs.file("thickness.vtp"),
        "--thickness-image", outputs.file("thickness.png") });
    const Outcome outcome = runMedialAxis(arguments, options);
    EXPECT_EQ(outcome.exitCode, exitCode) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind("medial-axis: ", 0), 0U) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(outputs.list(), std::vector<std::string>());
    return outcome.err;
  }

  void expectBadInput(const std::string& name, const std::string& content, const std::string& why)
  {
    writeFile(folder.file(name), content);
    const std::string error = failure(kBadInput, { folder.file(name) });
    EXPECT_TRUE(contains(error, folder.file(name))) << error;
    EXPECT_TRUE(contains(error, why)) << error;
  }

  TemporaryFolder folder;
  std::string input = folder.file("box.obj");
};

TEST_F(CommandFailure, MissingFile)
{
  const std::string error = failure(kBadInput, { folder.file("missing.stl") });
  EXPECT_TRUE(contains(error, "missing.stl: no such file")) << error;
}

TEST_F(CommandFailure, FolderAsInput)
{
  std::filesystem::create_directory(folder.file("folder.obj"));
  const std::string error = failure(kBadInput, { folder.file("folder.obj") });
  EXPECT_TRUE(contains(error, "is not a regular file")) << error;
}

TEST_F(CommandFailure, UnknownExtension)
{
  expectBadInput("mesh.step", "x", "unknown extension '.step', allowed: .stl .obj .ply .off");
}

TEST_F(CommandFailure, EmptyMesh)
{
  const TriangleMesh nothing;
  expectBadInput("empty.obj", "", "the file is empty");
  expectBadInput("cells.obj", objText(nothing) + "# none\n", "holds no faces");
  expectBadInput("empty.off", offText(nothing), "holds no faces");
  expectBadInput("empty.ply", plyText(nothing), "holds no faces");
  expectBadInput("empty.stl", stlBinary(nothing), "0 triangles");
  expectBadInput("empty.vtk", vtkText(nothing), "holds no faces");
}

TEST_F(CommandFailure, OnlyNaNs)
{
  TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  for (Point3& point : mesh.points)
  {
    point.fill(std::numeric_limits<double>::quiet_NaN());
  }
  expectBadInput("nan.obj", objText(mesh), "nan");
  expectBadInput("nan.off", offText(mesh), "nan");
  expectBadInput("nan.ply", plyText(mesh), "nan");
  expectBadInput("nan_binary.ply", plyBinary(mesh, false), "nan");
  expectBadInput("nan.stl", stlText(mesh), "nan");
  expectBadInput("nan_binary.stl", stlBinary(mesh), "nan");
  expectBadInput("nan.vtk", vtkText(mesh), "nan");
}

TEST_F(CommandFailure, TruncatedFiles)
{
  const TriangleMesh mesh = icosphere(1.0, 2);
  const std::string stl = stlBinary(mesh);
  const std::string ply = plyBinary(mesh, false);
  expectBadInput("cut.stl", stl.substr(0, stl.size() / 2), "320 triangles");
  expectBadInput("cut.ply", ply.substr(0, ply.size() / 2), "ends early");
}

TEST_F(CommandFailure, IndicesOutOfRange)
{
  TriangleMesh mesh = box({ 1.0, 1.0, 1.0 });
  mesh.triangles[5] = { 0, 1, 77 };
  expectBadInput("index.obj", objText(mesh), "point index 78 is outside [1, 8]");
  expectBadInput("index.ply", plyText(mesh), "point index 77 is outside [0, 7]");
}

TEST_F(CommandFailure, GridTooFine)
{
  const std::string error = failure(kBadInput, { input, "--spacing", "1e-6" });
  EXPECT_TRUE(contains(error, "8192")) << error;
}

TEST_F(CommandFailure, PseudonormalsOfAnOpenMesh)
{
  writeFile(input, objText(plates(0.5, 1.0)));
  const std::string error = failure(kBadInput, { input, "--sign", "pseudonormal" });
  EXPECT_TRUE(contains(error, input)) << error;
}

TEST_F(CommandFailure, OutputsThatCannotBeWritten)
{
  std::filesystem::create_directory(folder.file("folder.ma"));
  for (const std::string& path : { folder.file("no/such/folder/axis.ma"), folder.file("folder.ma"),
         folder.file("box.obj/axis.ma") })
  {
    const Outcome outcome = runMedialAxis({ input, "-o", path });
    EXPECT_EQ(outcome.exitCode, kNoSpace);
    EXPECT_TRUE(contains(outcome.err, path + ": cannot be written")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  }
}

TEST_F(CommandFailure, OneOutputThatCannotBeWrittenStopsTheOthers)
{
  const Outcome outcome = runMedialAxis(
    { input, "-o", folder.file("axis.ma"), "--report", folder.file("no/report.json") });
  EXPECT_EQ(outcome.exitCode, kNoSpace);
  EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
}

TEST_F(CommandFailure, FullDisk)
{
  RunOptions options;
  options.fileSizeLimit = 4096;
  const std::vector<std::pair<std::string, std::string>> outputs = { { "-o", "axis.vtp" },
    { "-o", "axis.ply" }, { "-o", "axis.obj" }, { "-o", "axis.ma" }, { "--field", "field.vti" },
    { "--field", "field.pvti" }, { "--image", "picture.png" } };
  for (const auto& [option, name] : outputs)
  {
    const std::string file = folder.file(name);
    writeFile(file, "old");
    const Outcome outcome = runMedialAxis({ input, option, file, "--resolution", "41" }, options);
    EXPECT_EQ(outcome.exitCode, kNoSpace) << name;
    const std::string culprit = name == "field.pvti" ? folder.file("field_0.vti") : file;
    EXPECT_TRUE(contains(outcome.err, culprit + ": cannot be written: ")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(readFile(file), "old");
    std::filesystem::remove(file);
  }
  EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
  failure(kNoSpace, { input, "--resolution", "41" }, options);
}

// What a program prints is an output as well, and may be its only one.
TEST_F(CommandFailure, StandardOutputThatCannotBeWritten)
{
  writeFile(folder.file("p.xyz"), "0 0 2\n");
  RunOptions options;
  options.output = "/dev/full";
  options.folder = folder.path();
  using Program = Outcome (*)(const std::vector<std::string>&, const RunOptions&);
  const std::tuple<Program, std::string, std::vector<std::string>> runs[] = {
    { runMedialAxis, "medial-axis", { input, "-o", "a.vtp", "--resolution", "20" } },
    { runMedialAxis, "medial-axis", { input, "--report", "-", "--resolution", "20" } },
    { runMedialAxis, "medial-axis", { "--help" } },
    { runMedialAxis, "medial-axis", { "--version" } },
    { runMedialDistance, "medial-distance", { input, "p.xyz" } },
    { runMedialDistance, "medial-distance", { "--help" } },
    { runMedialMeasure, "medial-measure", { "a.vtp", input, "--samples", "1000" } },
    { runMedialMeasure, "medial-measure", { "--help" } },
    { runMedialProximity, "medial-proximity", { input, input } },
    { runMedialProximity, "medial-proximity", { "--help" } },
    { runMedialViewer, "medial-viewer", { "--help" } }
  };
  for (const auto& [program, name, arguments] : runs)
  {
    const Outcome outcome = program(arguments, options);
    EXPECT_EQ(outcome.exitCode, kNoSpace) << name << " " << arguments.front();
    EXPECT_EQ(outcome.err,
      name + ": standard output: cannot be written: No space left on device\n");
  }
  EXPECT_EQ(runMedialDistance({ input, "p.xyz", "-q" }, options).exitCode, 0);
}

TEST_F(CommandFailure, FieldThatTheDiskCannotHold)
{
  writeFile(input, objText(box({ 1.0, 1.0, 1.0 })));
  RunOptions options;
  options.fileSizeLimit = 1L << 30; // in case there is a disk that can
  for (const char* name : { "field.vti", "field.pvti" })
  {
    writeFile(folder.file(name), "old");
    const Outcome outcome =
      runMedialAxis({ input, "--resolution", "8192", "--field", folder.file(name) }, options);
    EXPECT_EQ(outcome.exitCode, kNoSpace) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, ": cannot be written: ")) << outcome.err;
    EXPECT_EQ(readFile(folder.file(name)), "old");
  }
  EXPECT_EQ(folder.list(), (std::vector<std::string>{ "box.obj", "field.pvti", "field.vti" }));
  failure(kNoSpace, { input, "--resolution", "8192" }, options);
}

/// Without OpenGL, options that draw fail with a message; the engine processor works.
TEST_F(CommandFailure, NoEgl)
{
  std::filesystem::create_directory(folder.file("vendors"));
  RunOptions options;
  options.environment = { { "__EGL_VENDOR_LIBRARY_DIRS", folder.file("vendors") },
    { "__EGL_VENDOR_LIBRARY_FILENAMES", folder.file("vendors/none.json") } };
  for (const std::vector<std::string>& drawing :
    std::vector<std::vector<std::string>>{ { "--engine", "rasteriser" }, { "--engine", "device" },
      { "--require-gpu" }, { "--image", folder.file("axis.png") } })
  {
    const std::string axis = folder.file("drawn.ma");
    std::vector<std::string> arguments{ input, "--resolution", "16", "-o", axis };
    arguments.insert(arguments.end(), drawing.begin(), drawing.end());
    const Outcome outcome = runMedialAxis(arguments, options);
    EXPECT_EQ(outcome.exitCode, kNoGpu) << drawing[0];
    EXPECT_TRUE(contains(outcome.err, "no EGL device offers an OpenGL 4.5 core context"))
      << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(axis)) << drawing[0];
  }
  const std::string file = folder.file("axis.ma");
  const Outcome outcome = runMedialAxis({ input, "--resolution", "16", "-o", file }, options);
  EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
  EXPECT_FALSE(readFile(file).empty());
}

TEST_F(CommandFailure, DeviceThatIsNotThere)
{
  const std::string axis = folder.file("axis.ma");
  for (const std::string engine : { "device", "rasteriser" })
  {
    const Outcome outcome = runMedialAxis(
      { input, "--resolution", "8", "--engine", engine, "--device", "Voodoo", "-o", axis });
    EXPECT_EQ(outcome.exitCode, kNoGpu);
    EXPECT_TRUE(contains(outcome.err, "'Voodoo'")) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(axis));
  }
}

/// The engine auto leaves what the device should have done to the processor, with one note.
TEST_F(CommandFailure, DeviceThatIsNotThereLeavesTheWorkToTheProcessor)
{
  RunOptions withoutEgl;
  withoutEgl.environment = { { "__EGL_VENDOR_LIBRARY_FILENAMES", folder.file("none.json") } };
  const std::vector<std::tuple<std::string, RunOptions, std::string>> cases{
    { "Voodoo", {}, "'Voodoo'" }, { "0", withoutEgl, "'0'" }
  };
  for (const auto& [device, options, words] : cases)
  {
    for (const std::string output : { "axis.ma", "field.vti" })
    {
      const Outcome outcome =
        runMedialAxis({ input, "--resolution", "8", "--device", device,
                        output == "axis.ma" ? "-o" : "--field", folder.file(output) },
          options);
      EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
      EXPECT_EQ(outcome.err.rfind("medial-axis: note: the engine device failed (", 0), 0u)
        << outcome.err;
      EXPECT_TRUE(contains(outcome.err, words)) << outcome.err;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
      EXPECT_TRUE(contains(outcome.out, "engine    processor")) << outcome.out;
      EXPECT_FALSE(readFile(folder.file(output)).empty());
    }
  }
  EXPECT_EQ(runMedialAxis({ input, "--device", "Voodoo", "--require-gpu" }).exitCode, kNoGpu);
}

TEST_F(CommandFailure, WithoutEglNoDeviceIsListed)
{
  RunOptions options;
  options.environment = { { "__EGL_VENDOR_LIBRARY_FILENAMES", folder.file("none.json") } };
  const Outcome without = runMedialAxis({ "--list-devices" }, options);
  EXPECT_EQ(without.exitCode, 0) << without.err;
  EXPECT_TRUE(contains(without.out, "EGL offers no device")) << without.out;
}

TEST_F(CommandFailure, SoftwareRendererWhereHardwareIsRequired)
{
  const Outcome probe = runMedialAxis({ input, "--resolution", "8", "--engine", "rasteriser",
    "--report", folder.file("report.json") });
  ASSERT_EQ(probe.exitCode, 0) << probe.err;
  const auto device = nlohmann::json::parse(readFile(folder.file("report.json")))["device"];
  const Outcome outcome =
    runMedialAxis({ input, "--resolution", "8", "--require-gpu", "-o", folder.file("axis.ma") });
  EXPECT_EQ(outcome.exitCode, device["software"].get<bool>() ? kNoGpu : 0);
  if (outcome.exitCode == kNoGpu)
  {
    EXPECT_TRUE(contains(outcome.err, device["renderer"].get<std::string>())) << outcome.err;
  }
}

TEST_F(CommandFailure, InterruptLeavesNothingBehind)
{
  writeFile(input, objText(icosphere(1.0, 5)));
  writeFile(folder.file("axis.vtp"), "old");
  for (const int signal : { SIGINT, SIGTERM, SIGHUP })
  {
    RunOptions options;
    options.interruptAfter = 0.5;
    options.signal = signal;
    const Outcome outcome =
      runMedialAxis({ input, "--resolution", "512", "-o", folder.file("axis.vtp") }, options);
    EXPECT_EQ(outcome.exitCode, kInterrupted) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "interrupted")) << outcome.err;
    EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
    EXPECT_EQ(folder.list(), (std::vector<std::string>{ "axis.vtp", "box.obj" }));
    EXPECT_EQ(readFile(folder.file("axis.vtp")), "old");
  }
}

TEST_F(CommandFailure, InterruptLeavesNothingOfAField)
{
  writeFile(input, objText(icosphere(1.0, 5)));
  for (const char* name : { "field.vti", "field.pvti" })
  {
    writeFile(folder.file(name), "old");
    RunOptions options;
    options.interruptAfter = 0.7;
    const Outcome outcome =
      runMedialAxis({ input, "--resolution", "450", "--field", folder.file(name) }, options);
    EXPECT_EQ(outcome.exitCode, kInterrupted) << outcome.err;
    EXPECT_TRUE(contains(outcome.err, "interrupted")) << outcome.err;
    EXPECT_EQ(readFile(folder.file(name)), "old");
    std::filesystem::remove(folder.file(name));
    EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
  }
}

} // namespace
} // namespace medial::test
