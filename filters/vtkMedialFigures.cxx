#include "vtkMedialFigures.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include "medial/ranks.h"

#include <vector>

namespace
{

//------------------------------------------------------------------------------
template <typename ArrayType, typename ValueType>
ArrayType* AddTuple(vtkDataObject* output, const char* name, const ValueType* values,
  int components)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->InsertNextTypedTuple(values);
  output->GetFieldData()->AddArray(array);
  return array;
}

} // namespace

//------------------------------------------------------------------------------
vtkMedialFigures::vtkMedialFigures(vtkDataObject* output)
  : Output(output)
{
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddText(const char* name, const std::string& text)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  this->Output->GetFieldData()->AddArray(array);
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddFlag(const char* name, bool value)
{
  const unsigned char flag = value ? 1 : 0;
  AddTuple<vtkUnsignedCharArray>(this->Output, name, &flag, 1);
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddCount(const char* name, vtkIdType value)
{
  AddTuple<vtkIdTypeArray>(this->Output, name, &value, 1);
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddNumber(const char* name, double value)
{
  AddTuple<vtkDoubleArray>(this->Output, name, &value, 1);
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddPoint(const char* name, const std::array<double, 3>& values)
{
  AddTuple<vtkDoubleArray>(this->Output, name, values.data(), 3);
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddCounts(const char* name, const std::array<int, 3>& values)
{
  AddTuple<vtkIntArray>(this->Output, name, values.data(), 3);
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddParts(const char* name, std::initializer_list<Part> parts)
{
  std::vector<double> values;
  for (const Part& part : parts)
  {
    values.push_back(part.Value);
  }
  auto* array =
    AddTuple<vtkDoubleArray>(this->Output, name, values.data(), static_cast<int>(values.size()));
  vtkIdType component = 0;
  for (const Part& part : parts)
  {
    array->SetComponentName(component++, part.Name);
  }
}

//------------------------------------------------------------------------------
void vtkMedialFigures::AddRankCounts(const medial::RankCounts& counts)
{
  this->AddCount("OwnTriangles", counts.ownTriangles);
  this->AddCount("HeldTriangles", counts.heldTriangles);
  this->AddCount("BytesSent", counts.bytesSent);
}
