#pragma once

#include <map>
#include <string>
#include <vector>

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkCellArray;
class vtkPoints;

namespace medial::app
{

/// Says what is wrong with a file; readMesh() adds the file's name. Line 0 is an unknown one.
/// @throws Failure BadInput.
[[noreturn]] void refuse(const std::string& why);
[[noreturn]] void refuseLine(int line, const std::string& why);

/// Collects the points and cells of a file in double precision.
class SoupBuilder
{
public:
  SoupBuilder();
  ~SoupBuilder();
  SoupBuilder(const SoupBuilder&) = delete;
  SoupBuilder& operator=(const SoupBuilder&) = delete;

  void addPoint(double x, double y, double z);
  /// A polygon; with two points a line, with one a vertex. `line` is where the file names it.
  void addFace(const std::vector<long long>& pointIds, int line = 0);
  void addLine(const std::vector<long long>& pointIds, int line = 0);
  /// A triangle strip.
  void addStrip(const std::vector<long long>& pointIds, int line = 0);
  /// Every point a vertex, all of them one cell.
  void addVertices(const std::vector<long long>& pointIds, int line = 0);

  long long pointCount() const;

  /// @param firstIndex what the file calls its first point, for messages: 0 or 1.
  /// @throws Failure BadInput when a cell names a point that does not exist.
  vtkSmartPointer<vtkPolyData> finish(int firstIndex) const;

private:
  void add(vtkCellArray* cells, const std::vector<long long>& pointIds, int line);

  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> faces_, lines_, strips_, vertices_;
  long long largestIndex_ = -1, smallestIndex_ = 0;
  int largestIndexLine_ = 0, smallestIndexLine_ = 0;
};

/// Values of the vertices of a PLY file by the names of their properties.
using PlyAttributes = std::map<std::string, std::vector<double>>;

/// Readers of the formats that the programs read themselves, from the whole file's content.
/// @throws Failure BadInput without the file's name.
vtkSmartPointer<vtkPolyData> parseObj(const std::string& content);
/// @param attributes gets the values of those properties that it has entries for and the file has
///   too; may be null.
vtkSmartPointer<vtkPolyData> parsePly(const std::string& content,
  PlyAttributes* attributes = nullptr);
vtkSmartPointer<vtkPolyData> parseOff(const std::string& content);
vtkSmartPointer<vtkPolyData> parseLegacyVtk(const std::string& content);

} // namespace medial::app
