// What medial-proximity refuses, with one line, an exit code and no output.
#include "proximity_run.h"

#include <filesystem>
#include <string>
#include <vector>

namespace medial::test
{
namespace
{

class ProximityFailure : public ProximityRun
{
protected:
  // A usage error for a transform of mesh 1.
  std::string transformError(const std::string& matrix) const
  {
    return failure(kUsage, { large, small, "--transform", matrix });
  }

  std::string fileError(const std::string& content) const
  {
    const std::string file = folder.file("matrix.txt");
    writeFile(file, content);
    std::string error = failure(kBadInput, { large, small, "--transform", "1=" + file });
    EXPECT_TRUE(contains(error, file + ": ")) << error;
    return error;
  }
};

TEST_F(ProximityFailure, MissingSecondMesh)
{
  const std::string error = failure(kUsage, { large });
  EXPECT_TRUE(contains(error, "only one mesh, " + large)) << error;
  EXPECT_TRUE(contains(error, "allowed: two or more")) << error;
  failure(kUsage, {});
}

TEST_F(ProximityFailure, OptionsOutsideTheirRange)
{
  const std::vector<std::vector<std::string>> cases{
    { "--max-contacts", "0", "0 is outside [1, 2147483647]" },
    { "--max-contacts", "-3", "-3 is outside [1, 2147483647]" },
    { "--max-contacts", "four", "four is not a whole number" },
    { "--depth-tolerance", "0", "0 is outside (0, 1)" },
    { "--depth-tolerance", "1", "1 is outside (0, 1)" },
    { "--depth-tolerance", "nan", "nan is outside (0, 1)" },
    { "--max-separation", "-1", "-1 is outside [0, infinity)" },
    { "--max-separation", "inf", "inf is outside [0, infinity)" },
    { "--threads", "-1", "-1 is outside [0, 1024]" },
  };
  for (const auto& one : cases)
  {
    const std::string error = failure(kUsage, { large, small, one[0], one[1] });
    EXPECT_TRUE(contains(error, one[0])) << error;
    EXPECT_TRUE(contains(error, one[2])) << error;
  }
  EXPECT_TRUE(contains(failure(kUsage, { large, small, "--unknown" }), "--unknown"));
}

TEST_F(ProximityFailure, ExtensionsOfOutputs)
{
  const auto error = [&](const std::string& option, const std::string& name)
  {
    const Outcome outcome = runMedialProximity({ large, small, option, folder.file(name) });
    EXPECT_EQ(outcome.exitCode, kUsage);
    return outcome.err;
  };
  EXPECT_TRUE(contains(error("--json", "x.txt"), "unknown extension '.txt', allowed: .json"));
  EXPECT_TRUE(contains(error("--contacts", "x.vtu"), "'.vtu', allowed: .vtp .pvd"));
  EXPECT_TRUE(contains(error("--image", "x.jpg"), "'.jpg', allowed: .png"));
}

TEST_F(ProximityFailure, ContactsThatWouldReplaceAMesh)
{
  std::filesystem::rename(small, folder.file("small.vtp"));
  const Outcome outcome =
    runMedialProximity({ large, folder.file("small.vtp"), "--contacts", folder.file("small.vtp") });
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_TRUE(contains(outcome.err, "is the input file itself")) << outcome.err;
}

TEST_F(ProximityFailure, MatricesOnTheCommandLine)
{
  EXPECT_TRUE(contains(transformError("1=1,0,0,2,0,1,0,0,1,0,0,0"),
    "the matrix is singular: its determinant is 0"));
  EXPECT_TRUE(contains(transformError("1=0,0,0,0,0,0,0,0,0,0,0,0"), "singular"));
  // Rows that are one sum of the others but for rounding.
  EXPECT_TRUE(contains(transformError("1=0.1,0.2,0.3,0,0.7,0.1,0.9,0,0.8,0.3,1.2,0"), "singular"));
  EXPECT_TRUE(contains(transformError("1=1,0,0"), "3 numbers; allowed: 12 (3 x 4) or 16 (4 x 4)"));
  EXPECT_TRUE(
    contains(transformError("1=1,0,0,2,0,1,0,0,0,0,1,nan"), "'nan' is not a finite number"));
  EXPECT_TRUE(contains(transformError("1=1,0,0,2,0,1,0,0,0,0,1,1e999"), "'1e999' is not a finite"));
  EXPECT_TRUE(contains(transformError("1=1,0,0,2,0,1,0,0,0,0,1,x"), "'x' is not a finite number"));
  EXPECT_TRUE(contains(transformError("1=1,0,0,2,0,1,0,0,0,0,1,+-1"), "'+-1' is not a finite"));
  EXPECT_TRUE(contains(transformError("1=1,0,0,2,0,1,0,0,0,0,1,0,0,0,0,2"),
    "the last row of a 4 x 4 matrix is 0, 0, 0, 2; allowed: 0, 0, 0, 1"));
  EXPECT_TRUE(contains(transformError("2=1,0,0,2,0,1,0,0,0,0,1,0"), "number of a mesh, in [0, 1]"));
  EXPECT_TRUE(contains(transformError("1,0,0,2,0,1,0,0,0,0,1,0"), "number of a mesh, in [0, 1]"));
  const std::string same = "1=1,0,0,2,0,1,0,0,0,0,1,0";
  EXPECT_TRUE(contains(failure(kUsage, { large, small, "--transform", same, "--transform", same }),
    "mesh 1 has a transform already"));
}

TEST_F(ProximityFailure, MatricesInFiles)
{
  EXPECT_TRUE(contains(fileError(""), "the file is empty"));
  EXPECT_TRUE(contains(fileError("1 0 0 0\n0 1 0 0\n"), "a matrix has 8 numbers"));
  EXPECT_TRUE(contains(fileError("1 0 0 0\n0 1 0 0\n0 0 0 0\n"), "singular"));
  EXPECT_TRUE(contains(fileError("1 0 0 0\n0 1 0 0\n0 0 one 0\n"), "'one' is not a finite number"));
  const std::string row = "1 0 0 2 0 1 0 0 0 0 1 0\n";
  EXPECT_TRUE(contains(fileError(row + row), "has 2 matrices; more than one need --sequence"));
  EXPECT_TRUE(contains(fileError(row + "1 0 0 0\n"), "mixes lines"));
  EXPECT_TRUE(contains(failure(kBadInput, { large, small, "--transform", "1=absent.txt" }),
    "absent.txt: no such file"));
}

TEST_F(ProximityFailure, Meshes)
{
  EXPECT_TRUE(
    contains(failure(kBadInput, { large, folder.file("no.obj") }), "no.obj: no such file"));
  writeFile(small, "OFF\n0 0 0\n");
  EXPECT_TRUE(contains(failure(kBadInput, { large, small }), small + ": holds no faces"));
  writeFile(small, "OFF\n3 1 0\n0 0 0\n1 0 nan\n0 1 0\n3 0 1 2\n");
  EXPECT_TRUE(contains(failure(kBadInput, { large, small }), small + ": "));
  writeFile(small, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n");
  EXPECT_TRUE(contains(failure(kBadInput, { large, small }), small + ": "));
  EXPECT_TRUE(contains(failure(kBadInput, { large, folder.path().string() }),
    "is a folder; --sequence takes its meshes as frames"));
}

TEST_F(ProximityFailure, MeshesTooFarApart)
{
  // As far as the library can: exact.
  const Json far = json({ large, small, "--transform", "1=1,0,0,1e17,0,1,0,0,0,0,1,0" });
  EXPECT_NEAR(far["frames"][0]["pairs"][0]["separation"].get<double>() / 1e17, 1.0, 1e-12);
  const std::string error =
    failure(kBadInput, { large, small, "--transform", "1=1,0,0,2e18,0,1,0,0,0,0,1,0" });
  EXPECT_TRUE(contains(error, small + ": ")) << error;
  EXPECT_TRUE(contains(error, "beyond 1e+18")) << error;
}

TEST_F(ProximityFailure, OutputsThatCannotBeWritten)
{
  const std::string absent = folder.file("no/such/folder/");
  const std::vector<std::vector<std::string>> cases{ { "--json", absent + "a.json" },
    { "--contacts", absent + "a.vtp" }, { "--image", absent + "a.png" },
    { "--animation", absent + "pictures" }, { "--animation", large } };
  for (const auto& one : cases)
  {
    const Outcome outcome = runMedialProximity({ large, small, one[0], one[1] });
    EXPECT_EQ(outcome.exitCode, kNoSpace) << one[1];
    EXPECT_TRUE(contains(outcome.err, one[1] + ": cannot be ")) << outcome.err;
  }
}

TEST_F(ProximityFailure, FullDiskLeavesOldFilesAlone)
{
  RunOptions full;
  full.fileSizeLimit = 64;
  writeFile(folder.file("old.json"), "old");
  std::vector<std::string> arguments = cubes(2.0, { "-q", "--json", folder.file("old.json") });
  EXPECT_EQ(runMedialProximity(arguments, full).exitCode, kNoSpace);
  EXPECT_EQ(readFile(folder.file("old.json")), "old");
  failure(kNoSpace, { large, small }, full);
}

TEST_F(ProximityFailure, InterruptLeavesNothingBehind)
{
  std::string rows;
  for (int i = 0; i < 20000; ++i)
  {
    rows += "1 0 0 1.25 0 1 0 0 0 0 1 0\n";
  }
  const std::string file = folder.file("rows.txt");
  writeFile(file, rows);
  writeFile(small, offText(icosphere(0.5, 5)));
  RunOptions options;
  options.interruptAfter = 0.7;
  const TemporaryFolder outputs;
  const Outcome outcome =
    runMedialProximity({ large, small, "--sequence", "--transform", "1=" + file, "--json",
                         outputs.file("result.json"), "--animation", outputs.file("pictures") },
      options);
  EXPECT_EQ(outcome.exitCode, kInterrupted) << outcome.err;
  EXPECT_TRUE(contains(outcome.err, "interrupted")) << outcome.err;
  EXPECT_EQ(outputs.list(), std::vector<std::string>());
}

} // namespace
} // namespace medial::test
