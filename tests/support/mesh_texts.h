#pragma once

#include "medial/triangle_mesh.h"

#include <string>

// Meshes as the content of files. Coordinates have 17 digits in texts and are floats in binary
// files.
namespace medial::test
{

std::string objText(const TriangleMesh& mesh);
std::string offText(const TriangleMesh& mesh);
std::string plyText(const TriangleMesh& mesh);
/// The header of plyText() with another number of faces.
std::string plyText(const TriangleMesh& mesh, std::size_t faceCount);
std::string plyBinary(const TriangleMesh& mesh, bool bigEndian);
std::string stlText(const TriangleMesh& mesh);
std::string stlBinary(const TriangleMesh& mesh);
/// Legacy VTK, cells as sizes and ids.
std::string vtkText(const TriangleMesh& mesh);

} // namespace medial::test
