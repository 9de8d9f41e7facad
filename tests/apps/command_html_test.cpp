#include "program.h"
#include "support/mesh_texts.h"
#include "web/web_files.h"

#include "support/shapes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace medial::test
{
namespace
{

class CommandHtml : public ::testing::Test
{
protected:
  CommandHtml() { writeFile(input, objText(box({ 1.0, 0.7, 0.4 }))); }

  Outcome run(const std::string& page)
  {
    return runMedialAxis({ input, "--resolution", "24", "--html", page });
  }

  TemporaryFolder folder;
  std::string input = folder.file("box.obj");
};

// tests/web has the tests of pages, for builds with vtk.js.
TEST_F(CommandHtml, BuildsWithoutVtkJsSayHowToGetIt)
{
  const std::string file = folder.file("page.html");
  const Outcome outcome = run(file);
  if (!app::webFile("vtk.js").empty())
  {
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return;
  }
  EXPECT_EQ(outcome.exitCode, kUsage);
  for (const std::string& part :
    { "--html " + file, std::string("./check --web"), std::string("-DMEDIAL_VTKJS=") })
  {
    EXPECT_TRUE(contains(outcome.err, part)) << outcome.err;
  }
  EXPECT_EQ(folder.list(), std::vector<std::string>{ "box.obj" });
}

TEST_F(CommandHtml, RefusesOtherExtensions)
{
  const Outcome outcome = run("page.txt");
  EXPECT_EQ(outcome.exitCode, kUsage);
  EXPECT_TRUE(contains(outcome.err, "--html page.txt: unknown extension '.txt', allowed: .html"))
    << outcome.err;
}

TEST(WebFiles, UnknownNamesThrow)
{
  EXPECT_THROW(app::webFile("none.js"), std::out_of_range);
  EXPECT_TRUE(contains(std::string(app::webFile("page.html")), "{{data}}"));
}

} // namespace
} // namespace medial::test
