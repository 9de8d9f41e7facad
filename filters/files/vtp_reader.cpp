#include "files/vtp_reader.h"

#include "files/file_content.h"
#include "files/parsed_number.h"
#include "files/vtp_array.h"
#include "files/xml_elements.h"

#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace medial::files
{
namespace
{

// What a count promises is compared with the numbers that are there before memory is allocated.
std::int64_t countOf(const XmlElement& element, const char* attribute)
{
  static const std::string kNone = "0";
  const std::string& text = element.attribute(attribute, kNone);
  const std::int64_t count = parsedNumber<std::int64_t>(text).value_or(-1);
  if (count < 0)
  {
    refuseContent(
      std::string(attribute) + " is '" + text.substr(0, 40) + "', which is not a count");
  }
  return count;
}

vtkSmartPointer<vtkCellArray> toCells(std::vector<std::int64_t> ends,
  const std::vector<std::int64_t>& ids)
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  ends.insert(ends.begin(), 0);
  offsets->SetNumberOfValues(static_cast<vtkIdType>(ends.size()));
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ends.begin(), ends.end(), offsets->GetPointer(0));
  std::copy(ids.begin(), ids.end(), connectivity->GetPointer(0));
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, connectivity);
  return cells;
}

void checkCells(const std::string& kind, const std::vector<std::int64_t>& ends,
  const std::vector<std::int64_t>& ids, std::int64_t points)
{
  std::int64_t start = 0;
  for (const std::int64_t end : ends)
  {
    if (end < start)
    {
      refuseContent(
        kind + ": the offset " + std::to_string(end) + " comes after " + std::to_string(start));
    }
    start = end;
  }
  if (start != static_cast<std::int64_t>(ids.size()))
  {
    refuseContent(kind + ": the last offset is " + std::to_string(start) + ", but there are " +
      std::to_string(ids.size()) + " point ids");
  }
  const auto outside = std::find_if(ids.begin(), ids.end(),
    [points](std::int64_t id) { return id < 0 || id >= points; });
  if (outside != ids.end())
  {
    refuseContent("point index " + std::to_string(*outside) + " is outside [0, " +
      std::to_string(points - 1) + "]");
  }
}

class VtpParser
{
public:
  explicit VtpParser(const std::string& content)
    : elements_(scanXml(content, "AppendedData"))
    , arrays_(encodingOf(elements_), content.size())
  {
  }

  vtkSmartPointer<vtkPolyData> parse()
  {
    const XmlElement& root = elements_.front();
    const XmlElement* data = childOf(root, "PolyData");
    if (root.name != "VTKFile" || data == nullptr)
    {
      refuseContent(
        "not a VTK file of polygonal data: it has no element VTKFile with PolyData in it");
    }
    std::vector<vtkSmartPointer<vtkPolyData>> pieces;
    for (const std::size_t child : data->children)
    {
      if (elements_[child].name == "Piece")
      {
        pieces.push_back(parsePiece(elements_[child]));
      }
    }
    vtkSmartPointer<vtkPolyData> whole = joined(pieces);
    readFieldData(childOf(*data, "FieldData"), whole->GetFieldData());
    return whole;
  }

private:
  const XmlElement* childOf(const XmlElement& parent, const char* name) const
  {
    return files::childOf(elements_, parent, name);
  }

  // Every piece has data of its own around its points and cells, whatever their number.
  static vtkSmartPointer<vtkPolyData> joined(
    const std::vector<vtkSmartPointer<vtkPolyData>>& pieces)
  {
    if (pieces.size() == 1)
    {
      return pieces.front();
    }
    vtkNew<vtkAppendPolyData> append;
    for (const auto& piece : pieces)
    {
      append->AddInputData(piece);
    }
    if (!pieces.empty())
    {
      append->Update();
    }
    return append->GetOutput();
  }

  vtkSmartPointer<vtkPolyData> parsePiece(const XmlElement& piece)
  {
    constexpr std::size_t kMaxPieces = 1000;
    if (++pieces_ > kMaxPieces)
    {
      refuseContent("has more than " + std::to_string(kMaxPieces) + " pieces");
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    const std::int64_t points = countOf(piece, "NumberOfPoints");
    data->SetPoints(readPoints(childOf(piece, "Points"), points));
    data->SetVerts(readCells(piece, "Verts", points));
    data->SetLines(readCells(piece, "Lines", points));
    data->SetStrips(readCells(piece, "Strips", points));
    data->SetPolys(readCells(piece, "Polys", points));
    readAttributes(childOf(piece, "PointData"), points, data->GetPointData());
    readAttributes(childOf(piece, "CellData"), data->GetNumberOfCells(), data->GetCellData());
    return data;
  }

  vtkSmartPointer<vtkPoints> readPoints(const XmlElement* element, std::int64_t count)
  {
    auto points = vtkSmartPointer<vtkPoints>::New();
    const XmlElement* array = element == nullptr ? nullptr : childOf(*element, "DataArray");
    if (array == nullptr && count > 0)
    {
      refuseContent("its points are missing");
    }
    if (array != nullptr)
    {
      const auto coordinates = arrays_.read(*array, count);
      if (coordinates == nullptr || coordinates->GetNumberOfComponents() != 3)
      {
        refuseContent("its points have no three coordinates");
      }
      points->SetData(coordinates);
    }
    return points;
  }

  // Cells are the ends of their lists of ids, and these lists one after the other.
  vtkSmartPointer<vtkCellArray> readCells(const XmlElement& piece, const std::string& kind,
    std::int64_t points)
  {
    const std::int64_t count = countOf(piece, ("NumberOf" + kind).c_str());
    if (count == 0)
    {
      return vtkSmartPointer<vtkCellArray>::New();
    }
    const auto ends = readList(piece, kind, "offsets");
    const auto ids = readList(piece, kind, "connectivity");
    if (static_cast<std::int64_t>(ends.size()) != count)
    {
      refuseContent("NumberOf" + kind + " is " + std::to_string(count) + ", but there are " +
        std::to_string(ends.size()) + " offsets");
    }
    checkCells(kind, ends, ids, points);
    return toCells(ends, ids);
  }

  std::vector<std::int64_t> readList(const XmlElement& piece, const std::string& kind,
    const char* name)
  {
    if (const XmlElement* cells = childOf(piece, kind.c_str()))
    {
      for (const std::size_t child : cells->children)
      {
        if (elements_[child].attribute("Name", kind) == name)
        {
          return arrays_.readIntegers(elements_[child]);
        }
      }
    }
    refuseContent(kind + " has no array '" + name + "'");
  }

  void readAttributes(const XmlElement* element, std::int64_t tuples, vtkDataSetAttributes* to)
  {
    if (element == nullptr)
    {
      return;
    }
    for (const std::size_t child : element->children)
    {
      if (const auto array = arrays_.read(elements_[child], tuples))
      {
        to->AddArray(array);
      }
    }
    for (int type = 0; type < vtkDataSetAttributes::NUM_ATTRIBUTES; ++type)
    {
      const std::string name =
        element->attribute(vtkDataSetAttributes::GetAttributeTypeAsString(type), "");
      if (!name.empty())
      {
        to->SetActiveAttribute(name.c_str(), type);
      }
    }
  }

  void readFieldData(const XmlElement* element, vtkFieldData* to)
  {
    if (element == nullptr)
    {
      return;
    }
    for (const std::size_t child : element->children)
    {
      const std::int64_t tuples = countOf(elements_[child], "NumberOfTuples");
      if (const auto array = arrays_.read(elements_[child], tuples))
      {
        to->AddArray(array);
      }
    }
  }

  std::vector<XmlElement> elements_;
  VtpArrays arrays_;
  std::size_t pieces_ = 0;
};

} // namespace

vtkSmartPointer<vtkPolyData> readVtp(const fs::path& path)
{
  const std::string content = readContent(path);
  return withName(path, [&] { return VtpParser(content).parse(); });
}

} // namespace medial::files
