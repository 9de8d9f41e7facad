#pragma once

#include "input/surface.h"

#include "medial/triangle_mesh.h"

#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace medial::app
{

/// One frame of a deforming mesh.
struct Frame
{
  std::string name;                ///< of its file, without folder
  std::vector<Point3> points;      ///< of Sequence::mesh
  vtkSmartPointer<vtkPoints> seen; ///< of Sequence::surface
};

/// A deforming mesh: the same cells with other positions in every frame. A mesh that stands still
/// has one frame.
struct Sequence
{
  vtkSmartPointer<vtkPolyData> surface; ///< as read, with the points of the first frame
  TriangleMesh mesh;                    ///< with the points of the first frame
  Bounds bounds;                        ///< of all frames
  std::vector<Frame> frames;            ///< at least one
};

/// The files that the arguments name. A folder stands for the meshes in it, in the order of their
/// names, without hidden files, whose names begin with a dot.
/// @throws Failure BadInput for a folder without meshes.
std::vector<std::filesystem::path> filesOf(const std::vector<std::filesystem::path>& inputs);

///@{
/// Reads all frames.
/// @param read reads the file of one; readSurface() if omitted.
/// @throws Failure BadInput naming the file, also where its cells are not those of the first,
///   or come apart: points that are equal in the first frame must be so in all.
Sequence readSequence(const std::vector<std::filesystem::path>& inputs);
Sequence readSequence(const std::vector<std::filesystem::path>& inputs,
  const std::function<Surface(const std::filesystem::path&)>& read);
///@}

} // namespace medial::app
