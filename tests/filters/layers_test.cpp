// The library must stay usable without VTK.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace
{

namespace fs = std::filesystem;

TEST(Layers, NoFileOfTheLibraryIncludesVtk)
{
  const std::regex include(R"re(^\s*#\s*include\s*[<"]([^>"]*/)?vtk[^>"]*[>"])re");
  const std::regex filters(R"re(^\s*#\s*include\s*[<"][^>"]*filters/[^>"]*[>"])re");
  ASSERT_TRUE(std::regex_search("#include <vtkPolyData.h>", include));
  ASSERT_TRUE(std::regex_search("  # include \"vtk-9.1/vtkType.h\"", include));
  ASSERT_FALSE(std::regex_search("#include \"medial/mesh/topology.h\"", include));
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(MEDIAL_LIB_DIR))
  {
    const std::string extension = entry.path().extension().string();
    if (extension != ".h" && extension != ".cpp" && extension != ".in")
    {
      continue;
    }
    ++files;
    std::ifstream stream(entry.path());
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number)
    {
      EXPECT_FALSE(std::regex_search(line, include) || std::regex_search(line, filters))
        << entry.path() << ':' << number << ": " << line;
    }
  }
  EXPECT_GT(files, 10) << "nothing was searched";
}

TEST(Layers, TheBuildOfTheLibraryDoesNotNameVtk)
{
  std::ifstream stream(fs::path(MEDIAL_LIB_DIR) / "CMakeLists.txt");
  ASSERT_TRUE(stream);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    const std::string code = line.substr(0, line.find('#'));
    EXPECT_EQ(code.find("VTK"), std::string::npos) << "line " << number << ": " << line;
  }
}

} // namespace
