#pragma once

#include "program.h"
#include "support/mesh_texts.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

// Runs of medial-axis that must succeed, and the files that they write.
namespace medial::test
{

using Json = nlohmann::json;

std::set<std::string> keysOf(const Json& object);

/// The data that a reader of VTK gets from a file.
template <typename Reader>
auto readWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  EXPECT_EQ(reader->GetErrorCode(), 0U) << path;
  return vtkSmartPointer(reader->GetOutput());
}

vtkSmartPointer<vtkPolyData> readVtp(const std::string& path);
vtkSmartPointer<vtkImageData> readPng(const std::string& path);

/// A folder with a mesh to run medial-axis on.
class CommandRun : public ::testing::Test
{
protected:
  explicit CommandRun(const TriangleMesh& mesh, const std::string& name = "box.obj")
    : input(folder.file(name))
  {
    writeFile(input, objText(mesh));
  }

  /// Runs on the mesh, which must succeed.
  Outcome run(std::vector<std::string> arguments) const;

  TemporaryFolder folder;
  std::string input;
};

} // namespace medial::test
