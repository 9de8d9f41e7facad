#include "files/scans/scan_labels.h"

#include "files/parsed_number.h"
#include "files/scans/image_mask.h"
#include "files/scans/number_text.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <type_traits>

namespace medial::files
{
namespace
{

constexpr double kEndOfLabels = 9223372036854775808.0; // of long long

template <typename T>
bool hasLabel(T value, long long label)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    constexpr double kRounding = 1e-6;
    constexpr double kRounded = 1e3; // larger ones are labels only if they are whole
    const auto number = static_cast<double>(value);
    const double size = std::clamp(std::abs(static_cast<double>(label)), 1.0, kRounded);
    const double nearest = std::round(number); // NaN is equal to nothing
    return nearest >= -kEndOfLabels && nearest < kEndOfLabels &&
      static_cast<long long>(nearest) == label && std::abs(number - nearest) <= kRounding * size;
  }
  else if constexpr (std::is_signed_v<T>)
  {
    return static_cast<long long>(value) == label;
  }
  else
  {
    return label >= 0 &&
      static_cast<unsigned long long>(value) == static_cast<unsigned long long>(label);
  }
}

// With as many digits as tell a number from a whole one.
std::string digitsOf(double number)
{
  std::string text;
  for (const int digits : { 6, 9, 17 })
  {
    text = roundedText(number, digits);
    const double shown = parsedNumber<double>(text).value_or(number);
    if (std::floor(shown) != shown || std::floor(number) == number)
    {
      break;
    }
  }
  return text;
}

template <typename T>
std::string labelText(T value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    const auto number = static_cast<double>(value);
    const double nearest = std::round(number);
    if (std::abs(nearest) < kEndOfLabels && hasLabel(value, static_cast<long long>(nearest)))
    {
      return std::to_string(static_cast<long long>(nearest));
    }
    return digitsOf(number);
  }
  else
  {
    return std::to_string(value);
  }
}

template <typename T>
void mark(const T* values, vtkIdType count, long long label, unsigned char* marks)
{
  vtkSMPTools::For(0, count,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        marks[i] = hasLabel(values[i], label) ? 1 : 0;
      }
    });
}

template <typename T>
std::string listOf(const T* values, vtkIdType count)
{
  constexpr std::size_t kMost = 20;
  std::set<T> labels;
  for (vtkIdType i = 0; i < count && labels.size() <= kMost; ++i)
  {
    if (values[i] == values[i]) // NaN would have no place in the order
    {
      labels.insert(values[i]);
    }
  }
  std::string list;
  std::string last;
  std::size_t taken = 0;
  for (const T label : labels)
  {
    if (++taken > kMost)
    {
      return list + " and others";
    }
    const std::string text = labelText(label);
    if (text != last) // two numbers may be the same label
    {
      list += (list.empty() ? "" : ", ") + text;
    }
    last = text;
  }
  return list.empty() ? "none" : list;
}

} // namespace

vtkSmartPointer<vtkImageData> maskOfLabel(vtkImageData* image, long long label)
{
  return maskOf(image,
    [label](const auto* values, vtkIdType count, unsigned char* marks)
    { mark(values, count, label, marks); });
}

std::string labelsOf(vtkImageData* image)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const vtkIdType count = values->GetNumberOfTuples();
  std::string list = "none";
  switch (values->GetDataType())
  {
    vtkTemplateMacro(list = listOf(static_cast<const VTK_TT*>(values->GetVoidPointer(0)), count));
    default:
      break; // no type of numbers
  }
  return list;
}

} // namespace medial::files
