#include "files/scans/vti_reader.h"

#include "files/file_content.h"
#include "files/scans/header_text.h"
#include "files/scans/inflate.h"
#include "files/vtp_array.h"
#include "files/xml_elements.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <vector>

namespace medial::files
{
namespace
{

std::vector<double> numbersOf(const XmlElement& element, const std::string& key,
  const std::string& otherwise)
{
  return files::numbersOf({ { key, element.attribute(key, otherwise) } }, key);
}

std::vector<double> numbersOf(const XmlElement& element, const std::string& key,
  const std::string& otherwise, std::size_t count)
{
  std::vector<double> numbers = numbersOf(element, key, otherwise);
  if (numbers.size() != count)
  {
    refuseContent(
      key + " has " + std::to_string(numbers.size()) + " numbers, not " + std::to_string(count));
  }
  return numbers;
}

// The array that the element names, or else the first one with one component.
const XmlElement* scalarsOf(const std::vector<XmlElement>& elements, const XmlElement& piece)
{
  const XmlElement* pointData = childOf(elements, piece, "PointData");
  const XmlElement* chosen = nullptr;
  for (std::size_t i = 0; pointData != nullptr && i < pointData->children.size(); ++i)
  {
    const XmlElement& array = elements[pointData->children[i]];
    if (array.attribute("NumberOfComponents", "1") != "1")
    {
      continue;
    }
    const bool named = array.attribute("Name", "") == pointData->attribute("Scalars", "");
    chosen = chosen == nullptr || named ? &array : chosen;
  }
  return chosen;
}

} // namespace

Scan parseVti(const std::string& content)
{
  const std::vector<XmlElement> elements = scanXml(content, "AppendedData");
  const XmlElement* image = childOf(elements, elements.front(), "ImageData");
  if (elements.front().name != "VTKFile" || image == nullptr)
  {
    refuseContent("not a VTK file of an image: it has no element VTKFile with ImageData in it");
  }
  const XmlElement* piece = childOf(elements, *image, "Piece");
  static const std::string kNone;
  const std::string& whole = image->attribute("WholeExtent", kNone);
  if (piece == nullptr || wordsOf(piece->attribute("Extent", whole)) != wordsOf(whole))
  {
    refuseContent("has no piece with the whole image");
  }
  const std::vector<double> extent = numbersOf(*image, "WholeExtent", "", 6);
  const std::vector<double> spacing = numbersOf(*image, "Spacing", "1 1 1", 3);
  const std::vector<double> origin = numbersOf(*image, "Origin", "0 0 0", 3);
  const std::vector<double> direction = numbersOf(*image, "Direction", "1 0 0 0 1 0 0 0 1", 9);

  ScanHeader header;
  std::array<std::array<double, 3>, 3> steps{};
  std::array<double, 3> first = { origin[0], origin[1], origin[2] };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    constexpr double kLargest = 1e9;
    const double low = extent[2 * axis];
    const double high = extent[2 * axis + 1];
    if (!(low <= high && std::abs(low) < kLargest && std::abs(high) < kLargest))
    {
      refuseContent("WholeExtent is empty or too large");
    }
    header.dimensions[axis] = static_cast<std::int64_t>(high - low) + 1;
    for (std::size_t row = 0; row < 3; ++row)
    {
      steps[axis][row] = direction[3 * row + axis] * spacing[axis];
      first[row] += low * steps[axis][row];
    }
  }
  const XmlElement* scalars = scalarsOf(elements, *piece);
  if (scalars == nullptr)
  {
    refuseContent("its points have no array of one value each");
  }
  VtpArrays arrays(encodingOf(elements), content.size(), kLargestRatio);
  const auto values = arrays.read(*scalars, static_cast<std::int64_t>(header.voxels()));
  if (values == nullptr || values->GetNumberOfComponents() != 1)
  {
    refuseContent("the values of its points are not numbers");
  }
  auto data = vtkSmartPointer<vtkImageData>::New();
  data->SetDimensions(static_cast<int>(header.dimensions[0]),
    static_cast<int>(header.dimensions[1]), static_cast<int>(header.dimensions[2]));
  data->GetPointData()->SetScalars(values);
  return { data, makeFrame(first, steps) };
}

} // namespace medial::files
