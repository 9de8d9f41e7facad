// The library must stay usable without VTK.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace
{

namespace fs = std::filesystem;

/// What a line includes, or nothing.
std::string includedBy(const std::string& line)
{
  std::istringstream stream(line);
  char hash = 0;
  std::string keyword;
  stream >> hash;
  std::getline(stream >> std::ws, keyword);
  const std::size_t first = keyword.find_first_of("<\"");
  const std::size_t last = keyword.find_last_of(">\"");
  if (hash != '#' || keyword.compare(0, 7, "include") != 0 || first >= last)
  {
    return {};
  }
  return keyword.substr(first + 1, last - first - 1);
}

/// Headers of VTK and of the filters.
bool isForeign(const std::string& header)
{
  return fs::path(header).filename().string().compare(0, 3, "vtk") == 0 ||
    header.find("filters/") != std::string::npos;
}

TEST(Layers, NoFileOfTheLibraryIncludesVtk)
{
  ASSERT_TRUE(isForeign(includedBy("#include <vtkPolyData.h>")));
  ASSERT_TRUE(isForeign(includedBy("  # include \"vtk-9.1/vtkType.h\" // types")));
  ASSERT_FALSE(isForeign(includedBy("#include \"medial/mesh/topology.h\"")));
  ASSERT_FALSE(isForeign(includedBy("// as in <vtkType.h>")));
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
      EXPECT_FALSE(isForeign(includedBy(line))) << entry.path() << ':' << number << ": " << line;
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
