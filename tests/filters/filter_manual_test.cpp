// The headers are the manual: every parameter is explained, and PrintSelf() shows it.
#include <gtest/gtest.h>

#include <vtkMedialAxis.h>
#include <vtkMedialCurves.h>
#include <vtkMedialReconstruction.h>
#include <vtkMedialThickness.h>
#include <vtkMeshDistanceField.h>
#include <vtkNew.h>

#include <filesystem>
#include <fstream>
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

/// What lies between `open` and `close` in `text` from `position` on, which moves behind it; npos
/// is the position when there is no more.
std::string nextBetween(const std::string& text, const std::string& open, const std::string& close,
  std::size_t& position)
{
  const std::size_t start = text.find(open, position);
  const std::size_t end =
    start == std::string::npos ? start : text.find(close, start + open.size());
  position = end == std::string::npos ? end : end + close.size();
  return end == std::string::npos ? std::string()
                                  : text.substr(start + open.size(), end - start - open.size());
}

/// Names of the parameters that a text has set macros for.
std::vector<std::string> settersIn(const std::string& text)
{
  std::vector<std::string> names;
  for (const char* macro : { "vtkSetMacro(", "vtkSetVector3Macro(" })
  {
    for (std::size_t position = 0;;)
    {
      const std::string name = nextBetween(text, macro, ",", position);
      if (position == std::string::npos)
      {
        break;
      }
      names.push_back(name);
    }
  }
  return names;
}

/// Every parameter that a header explains in a block, with its explanation.
std::vector<Parameter> parametersOf(const std::string& header)
{
  std::vector<Parameter> parameters;
  for (std::size_t position = 0;;)
  {
    const std::string block = nextBetween(header, "///@{", "///@}", position);
    if (position == std::string::npos)
    {
      return parameters;
    }
    std::size_t code = 0;
    const std::string manual = nextBetween(block, "/**", "*/", code);
    if (code != std::string::npos)
    {
      for (const std::string& name : settersIn(block.substr(code)))
      {
        parameters.push_back({ name, manual });
      }
    }
  }
}

int setMacrosIn(const std::string& header)
{
  int count = 0;
  for (std::size_t position = header.find("vtkSet"); position != std::string::npos;
       position = header.find("vtkSet", position + 1))
  {
    count += header.substr(position, header.find('(', position) - position).find("Macro") !=
        std::string::npos
      ? 1
      : 0;
  }
  return count;
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
  expectManual("vtkMeshFieldAlgorithm", 15, printed<vtkMeshDistanceField>());
  expectManual("vtkMeshFieldAlgorithm", 15, printed<vtkMedialAxis>());
}

TEST(FilterManual, DistanceFieldHasNoParametersOfItsOwn)
{
  expectManual("vtkMeshDistanceField", 0, printed<vtkMeshDistanceField>());
}

TEST(FilterManual, MedialAxisParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialAxis", 8, printed<vtkMedialAxis>());
}

TEST(FilterManual, MedialCurvesParametersArePrinted)
{
  const std::string print = printed<vtkMedialCurves>();
  for (const char* name : { "Rims: On", "Seams: On", "Curves: On" })
  {
    EXPECT_NE(print.find(name), std::string::npos) << name;
  }
}

TEST(FilterManual, ReconstructionParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialReconstruction", 2, printed<vtkMedialReconstruction>());
}

TEST(FilterManual, MedialThicknessParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialThickness", 3, printed<vtkMedialThickness>());
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
      EXPECT_TRUE(headers.find("Get" + name + "(") != std::string::npos ||
        headers.find("Macro(" + name + ",") != std::string::npos)
        << line;
    }
  }
  EXPECT_GE(checked, 18);
}

} // namespace
