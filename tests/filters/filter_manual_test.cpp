// The headers are the manual: every parameter is explained, and PrintSelf() shows it.
#include <gtest/gtest.h>

#include <vtkMedialAxis.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

struct Parameter
{
  std::string name;
  std::string manual; ///< the comment of its ///@{ ... ///@} block
};

std::string headerOf(const std::string& name)
{
  std::ifstream stream(std::filesystem::path(MEDIAL_FILTERS_DIR) / (name + ".h"));
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Every parameter that a header has a set macro for.
std::vector<Parameter> parametersOf(const std::string& header)
{
  const std::regex block(R"re(///@\{\s*/\*\*([\s\S]*?)\*/([\s\S]*?)///@\})re");
  const std::regex setter(R"re(vtkSet(?:Vector3)?Macro\((\w+),)re");
  std::vector<Parameter> parameters;
  for (std::sregex_iterator it(header.begin(), header.end(), block), end; it != end; ++it)
  {
    const std::string code = (*it)[2];
    for (std::sregex_iterator found(code.begin(), code.end(), setter); found != end; ++found)
    {
      parameters.push_back({ (*found)[1], (*it)[1] });
    }
  }
  return parameters;
}

int setMacrosIn(const std::string& header)
{
  const std::regex setter(R"re(vtkSet\w*Macro\()re");
  return static_cast<int>(
    std::distance(std::sregex_iterator(header.begin(), header.end(), setter), {}));
}

template <typename Filter>
std::string printed()
{
  vtkNew<Filter> filter;
  std::stringstream text;
  filter->Print(text);
  return text.str();
}

void expectManual(const std::string& name, int count, const std::string& print)
{
  const std::string header = headerOf(name);
  const std::vector<Parameter> parameters = parametersOf(header);
  EXPECT_EQ(static_cast<int>(parameters.size()), count);
  EXPECT_EQ(setMacrosIn(header), count) << "a setter of " << name << " has no ///@{ /** block";
  std::set<std::string> manuals;
  for (const Parameter& parameter : parameters)
  {
    EXPECT_NE(parameter.manual.find("Default is "), std::string::npos)
      << parameter.name << " does not tell its default";
    EXPECT_GT(parameter.manual.size(), 80u) << parameter.name << " is hardly explained";
    EXPECT_TRUE(manuals.insert(parameter.manual).second) << parameter.name;
    EXPECT_NE(header.find("Macro(" + parameter.name + ',', header.find("vtkGet")),
      std::string::npos)
      << parameter.name << " cannot be read";
    EXPECT_NE(print.find("\n  " + parameter.name + ": "), std::string::npos)
      << parameter.name << " is not printed";
  }
}

TEST(FilterManual, CommonParametersAreExplainedAndPrinted)
{
  expectManual("vtkMeshFieldAlgorithm", 14, printed<vtkMeshDistanceField>());
  expectManual("vtkMeshFieldAlgorithm", 14, printed<vtkMedialAxis>());
}

TEST(FilterManual, DistanceFieldHasNoParametersOfItsOwn)
{
  expectManual("vtkMeshDistanceField", 0, printed<vtkMeshDistanceField>());
}

TEST(FilterManual, MedialAxisParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialAxis", 4, printed<vtkMedialAxis>());
}

// Nothing is printed as a parameter that no header explains.
TEST(FilterManual, PrintedNamesAreInTheHeaders)
{
  const std::string headers = headerOf("vtkMeshFieldAlgorithm") + headerOf("vtkMedialAxis") +
    headerOf("vtkMeshDistanceField");
  std::istringstream lines(printed<vtkMedialAxis>());
  std::string line;
  bool own = false;
  int checked = 0;
  while (std::getline(lines, line))
  {
    if (line.size() < 3)
    {
      continue;
    }
    const std::string name = line.substr(2, line.find(':') - 2);
    own = own || name == "GridMode"; // what precedes it is printed by VTK
    if (own)
    {
      ++checked;
      EXPECT_TRUE(std::regex_search(headers, std::regex("Get" + name + "\\b")) ||
        std::regex_search(headers, std::regex("Macro\\(" + name + ",")))
        << line;
    }
  }
  EXPECT_GE(checked, 18);
}

} // namespace
