// The headers are the manual: every parameter is explained, and PrintSelf() shows it.
#include "filter_support.h"

#include <gtest/gtest.h>

#include <vtkFieldData.h>
#include <vtkMedialAxis.h>
#include <vtkMedialCurves.h>
#include <vtkMedialLocalThickness.h>
#include <vtkMedialReconstruction.h>
#include <vtkMedialSkeleton.h>
#include <vtkMedialThickness.h>
#include <vtkMeshDistanceField.h>
#include <vtkMeshPointDistance.h>
#include <vtkMeshProximity.h>
#include <vtkNew.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace
{

using namespace medial::test;

struct Parameter
{
  std::string name;
  std::string manual; ///< the comment of its ///@{ ... ///@} block
};

std::string fileOf(const std::string& name)
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

/// A header with the declarations of parameters that several filters have in place of their macros.
std::string headerOf(const std::string& name)
{
  std::string header = fileOf(name);
  const std::string macros = fileOf("vtkMedialParameters");
  for (std::size_t position = macros.find("#include");;)
  {
    const std::string macro = nextBetween(macros, "#define vtkMedial", "()", position);
    if (position == std::string::npos)
    {
      return header;
    }
    const std::string call = "  vtkMedial" + macro + "();";
    const std::size_t place = header.find(call);
    if (place != std::string::npos)
    {
      const std::size_t end = macros.find("\n\n", position);
      header.replace(place, call.size(), macros.substr(position, end - position) + ';');
    }
  }
}

/// Names of the texts that are parameters: their setters are functions, since VTK's macro for them
/// modifies a filter whose value stays the same.
std::vector<std::string> textsIn(const std::string& text)
{
  std::vector<std::string> names;
  for (std::size_t position = 0;;)
  {
    const std::string declaration = nextBetween(text, "virtual void Set", ";", position);
    if (position == std::string::npos)
    {
      return names;
    }
    const std::size_t end = declaration.find("(const char*");
    if (end != std::string::npos)
    {
      names.push_back(declaration.substr(0, end));
    }
  }
}

/// Names of the parameters that a text has set macros for, or setters of texts.
std::vector<std::string> settersIn(const std::string& text)
{
  std::vector<std::string> names = textsIn(text);
  for (const char* macro : { "vtkSetMacro(", "vtkSetVector3Macro(" })
  {
    for (std::size_t position = 0;;)
    {
      const std::string arguments = nextBetween(text, macro, ")", position);
      if (position == std::string::npos)
      {
        break;
      }
      names.push_back(arguments.substr(0, arguments.find(',')));
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

bool hasMacro(const std::string& header, const std::string& name)
{
  return header.find("Macro(" + name + ',') != std::string::npos ||
    header.find("Macro(" + name + ')') != std::string::npos;
}

int settersDeclaredIn(const std::string& header)
{
  auto count = static_cast<int>(textsIn(header).size());
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
  EXPECT_EQ(settersDeclaredIn(header), count)
    << "a setter of " << name << " has no ///@{ /** block";
  std::set<std::string> manuals;
  for (const Parameter& parameter : parameters)
  {
    EXPECT_NE(parameter.manual.find("Default is"), std::string::npos)
      << parameter.name << " does not tell its default";
    EXPECT_GT(parameter.manual.size(), 80u) << parameter.name << " is hardly explained";
    EXPECT_TRUE(manuals.insert(parameter.manual).second) << parameter.name;
    EXPECT_TRUE(hasMacro(header.substr(header.find("vtkGet")), parameter.name))
      << parameter.name << " cannot be read";
    EXPECT_NE(print.find("\n  " + parameter.name + ": "), std::string::npos)
      << parameter.name << " is not printed";
  }
}

TEST(FilterManual, CommonParametersAreExplainedAndPrinted)
{
  expectManual("vtkMeshFieldAlgorithm", 16, printed<vtkMeshDistanceField>());
  expectManual("vtkMeshFieldAlgorithm", 16, printed<vtkMedialAxis>());
}

TEST(FilterManual, DistanceFieldParametersAreExplainedAndPrinted)
{
  expectManual("vtkDistributedFieldAlgorithm", 1, printed<vtkMeshDistanceField>());
  expectManual("vtkDistributedFieldAlgorithm", 1, printed<vtkMedialAxis>());
}

TEST(FilterManual, MedialAxisParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialAxis", 8, printed<vtkMedialAxis>());
}

TEST(FilterManual, MedialCurvesParametersAreExplainedAndPrinted)
{
  const std::string print = printed<vtkMedialCurves>();
  expectManual("vtkMedialCurves", 3, print);
  for (const char* name : { "Rims: On", "Seams: On", "Curves: On" })
  {
    EXPECT_NE(print.find(name), std::string::npos) << name;
  }
}

// The manuals name every array of the outputs.
TEST(FilterManual, OutputsHaveNoArraysThatTheManualsDoNotName)
{
  vtkNew<vtkMedialAxis> axis;
  axis->SetInputData(boxPolyData());
  axis->SetResolution(12);
  axis->GenerateDistanceFieldOn();
  vtkNew<vtkMedialThickness> thickness;
  thickness->SetInputData(boxPolyData());
  thickness->SetMaximumEdgeLength(0.5);
  thickness->SetMinimumThickness(0.1);
  vtkNew<vtkMedialCurves> curves;
  curves->SetInputConnection(axis->GetOutputPort());
  vtkNew<vtkMedialReconstruction> surface;
  surface->SetInputConnection(axis->GetOutputPort());
  surface->SetResolution(12);
  vtkNew<vtkMedialSkeleton> skeleton;
  skeleton->SetInputData(boxPolyData());
  skeleton->SetResolution(24);
  vtkNew<vtkMedialLocalThickness> local;
  local->SetInputData(boxPolyData());
  local->SetResolution(16);
  local->SetSideToBoth();
  vtkNew<vtkMeshProximity> proximity;
  proximity->SetInputData(0, boxPolyData());
  proximity->SetInputData(1, boxPolyData({ 2.0, 0.5, 0.5 }));
  vtkNew<vtkMeshPointDistance> distance;
  distance->SetInputDataObject(boxPolyData());
  distance->SetSurfaceData(boxPolyData());
  const std::string grid = headerOf("vtkMeshFieldAlgorithm");
  const auto expectNamed = [&](vtkAlgorithm* filter, int port, const std::string& manual)
  {
    filter->Update(port);
    vtkDataObject* output = filter->GetOutputDataObject(port);
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::FIELD })
    {
      vtkFieldData* arrays = output->GetAttributesAsFieldData(type);
      for (int i = 0; arrays && i < arrays->GetNumberOfArrays(); ++i)
      {
        EXPECT_NE(manual.find(arrays->GetArrayName(i)), std::string::npos)
          << arrays->GetArrayName(i) << " of " << filter->GetClassName();
      }
    }
  };
  const std::string ofAxis = headerOf("vtkMedialAxis");
  expectNamed(axis, 0, ofAxis.substr(0, ofAxis.find("#ifndef")) + grid);
  expectNamed(axis, 1, headerOf("vtkMeshDistanceField") + ofAxis + grid);
  expectNamed(thickness, 0, headerOf("vtkMedialThickness"));
  expectNamed(curves, 0, headerOf("vtkMedialCurves") + ofAxis + grid); // with those of the axis
  expectNamed(surface, 0, headerOf("vtkMedialReconstruction"));
  expectNamed(skeleton, 0, headerOf("vtkMedialSkeleton") + grid);
  expectNamed(local, 0, headerOf("vtkMedialLocalThickness") + grid);
  expectNamed(distance, 0, headerOf("vtkMeshPointDistance"));
  for (const int port : { 0, 1, 2 })
  {
    expectNamed(proximity, port, headerOf("vtkMeshProximity"));
  }
}

TEST(FilterManual, ReconstructionParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialReconstruction", 3, printed<vtkMedialReconstruction>());
}

TEST(FilterManual, MedialThicknessParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialThickness", 9, printed<vtkMedialThickness>());
}

TEST(FilterManual, MedialLocalThicknessParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialLocalThickness", 2, printed<vtkMedialLocalThickness>());
}

TEST(FilterManual, MedialSkeletonParametersAreExplainedAndPrinted)
{
  expectManual("vtkMedialSkeleton", 5, printed<vtkMedialSkeleton>());
}

TEST(FilterManual, MeshPointDistanceParametersAreExplainedAndPrinted)
{
  expectManual("vtkMeshPointDistance", 2, printed<vtkMeshPointDistance>());
}

TEST(FilterManual, MeshProximityParametersAreExplainedAndPrinted)
{
  const std::string print = printed<vtkMeshProximity>();
  expectManual("vtkMeshProximity", 7, print);
  for (const char* name : { "TransformA: ", "TransformB: " })
  {
    EXPECT_NE(print.find(name), std::string::npos) << name;
  }
}

// Nothing is printed as a parameter that no header explains.
TEST(FilterManual, PrintedNamesAreInTheHeaders)
{
  const std::string headers = headerOf("vtkMeshFieldAlgorithm") + headerOf("vtkMedialAxis") +
    headerOf("vtkDistributedFieldAlgorithm");
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
      EXPECT_TRUE(headers.find("Get" + name + "(") != std::string::npos || hasMacro(headers, name))
        << line;
    }
  }
  EXPECT_GE(checked, 18);
}

} // namespace
