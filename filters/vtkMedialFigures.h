/**
 * Figures of an execution as field data of its output. Private to the module.
 */

#ifndef vtkMedialFigures_h
#define vtkMedialFigures_h

#include "vtkType.h" // For vtkIdType

#include <array>
#include <initializer_list>
#include <string>

class vtkDataObject;
namespace medial
{
struct RankCounts;
}

/**
 * Adds field data arrays of one tuple each, in place of any of the same name.
 */
class vtkMedialFigures
{
public:
  explicit vtkMedialFigures(vtkDataObject* output);

  void AddText(const char* name, const std::string& text);
  void AddFlag(const char* name, bool value); // unsigned char, 0 or 1
  void AddCount(const char* name, vtkIdType value);
  void AddNumber(const char* name, double value);
  void AddPoint(const char* name, const std::array<double, 3>& values);
  void AddCounts(const char* name, const std::array<int, 3>& values);

  /**
   * A number that belongs to the others of the array: a component with a name of its own.
   */
  struct Part
  {
    const char* Name;
    double Value;
  };
  void AddParts(const char* name, std::initializer_list<Part> parts);

  /**
   * What a rank has held and sent: OwnTriangles, HeldTriangles and BytesSent.
   */
  void AddRankCounts(const medial::RankCounts& counts);

private:
  vtkDataObject* Output;
};

#endif
