#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/scalar_reader.h"
#include "io/soup_builder.h"
#include "io/text_cursor.h"

#include <cmath>

namespace medial
{
namespace
{

class LegacyVtkParser
{
public:
  explicit LegacyVtkParser(const std::string& content)
    : text_(content)
    , largestCount_(static_cast<std::int64_t>(content.size()))
  {
  }

  MeshInput parse()
  {
    readHeader();
    for (std::string_view keyword = text_.word(); !keyword.empty(); keyword = text_.word())
    {
      if (keyword == "POINT_DATA" || keyword == "CELL_DATA")
      {
        break;
      }
      readSection(keyword);
    }
    return soup_.finish(0);
  }

private:
  void readHeader()
  {
    char magic[14];
    if (!text_.takeBytes(magic, sizeof(magic)) ||
      std::string_view(magic, sizeof(magic)) != "# vtk DataFile")
    {
      refuse("not a VTK file: it does not start with '# vtk DataFile'");
    }
    text_.nextLine();
    text_.nextLine(); // the title
    const std::string_view encoding = text_.word();
    if (encoding != "ASCII" && encoding != "BINARY")
    {
      refuseLine(text_.line(), "'" + std::string(encoding) + "' is neither ASCII nor BINARY");
    }
    encoding_ = encoding == "BINARY" ? Encoding::BigEndian : Encoding::Text;
    if (text_.word() != "DATASET")
    {
      refuseLine(text_.line(), "DATASET is missing");
    }
    const std::string dataset(text_.word());
    if (dataset != "POLYDATA")
    {
      refuseLine(text_.line(), "the data set is '" + dataset + "', not POLYDATA");
    }
  }

  void readSection(std::string_view keyword)
  {
    if (keyword == "POINTS")
    {
      readPoints();
    }
    else if (keyword == "POLYGONS")
    {
      readCells(&SoupBuilder::addFace);
    }
    else if (keyword == "LINES")
    {
      readCells(&SoupBuilder::addLine);
    }
    else if (keyword == "TRIANGLE_STRIPS")
    {
      readCells(&SoupBuilder::addStrip);
    }
    else if (keyword == "VERTICES")
    {
      readCells(&SoupBuilder::addVertices);
    }
    else if (keyword == "METADATA")
    {
      skipParagraph();
    }
    else if (keyword == "FIELD")
    {
      skipField();
    }
    else
    {
      refuse("unknown keyword '" + std::string(keyword.substr(0, 20)) + "'");
    }
  }

  std::int64_t readCount()
  {
    const std::string_view word = text_.wordOnLine();
    const auto count = toInteger(word);
    if (!count || *count < 0 || *count > largestCount_)
    {
      refuseLine(text_.line(), "'" + std::string(word) + "' is not a count that the file can hold");
    }
    return *count;
  }

  ScalarType readType()
  {
    const std::string name = lowerCase(std::string(text_.wordOnLine()));
    const auto type = toScalarType(name);
    if (!type)
    {
      refuseLine(text_.line(), "'" + name + "' is not a type");
    }
    return *type;
  }

  std::vector<double> readNumbers(std::int64_t count, ScalarType type, const char* section)
  {
    ScalarReader reader(text_, encoding_);
    std::vector<double> numbers;
    for (std::int64_t i = 0; i < count; ++i)
    {
      const auto number = reader.next(type);
      if (!number)
      {
        refuse(std::string("ends early or is damaged: ") + section + " has " +
          std::to_string(count) + " numbers, number " + std::to_string(i + 1) + " cannot be read");
      }
      numbers.push_back(*number);
    }
    return numbers;
  }

  void readPoints()
  {
    const std::int64_t count = readCount();
    const std::vector<double> xyz = readNumbers(3 * count, readType(), "POINTS");
    for (std::size_t i = 0; i < xyz.size(); i += 3)
    {
      soup_.addPoint(xyz[i], xyz[i + 1], xyz[i + 2]);
    }
  }

  using Add = void (SoupBuilder::*)(const std::vector<std::int64_t>&, int);

  // Since version 5.1 cells are lists of offsets and connectivity; before, they are one list of
  // sizes and ids.
  void readCells(Add add)
  {
    const std::int64_t first = readCount();
    const std::int64_t second = readCount();
    TextCursor ahead = text_;
    if (ahead.word() != "OFFSETS")
    {
      addSizedCells(readNumbers(second, ScalarType::Int32, "a list of cells"), first, add);
      return;
    }
    text_ = ahead;
    const std::vector<double> offsets = readNumbers(first, readType(), "OFFSETS");
    if (text_.word() != "CONNECTIVITY")
    {
      refuse("CONNECTIVITY is missing");
    }
    addOffsetCells(offsets, readNumbers(second, readType(), "CONNECTIVITY"), add);
  }

  void addSizedCells(const std::vector<double>& list, std::int64_t cells, Add add)
  {
    std::size_t next = 0;
    for (std::int64_t cell = 0; cell < cells; ++cell)
    {
      const double size = next < list.size() ? list[next] : -1.0;
      if (!(size >= 0.0 && size < static_cast<double>(list.size() - next)))
      {
        refuse("cell " + std::to_string(cell) + " does not fit into its list of cells");
      }
      addCell(list.data() + next + 1, static_cast<std::size_t>(size), add);
      next += 1 + static_cast<std::size_t>(size);
    }
  }

  void addOffsetCells(const std::vector<double>& offsets, const std::vector<double>& connectivity,
    Add add)
  {
    for (std::size_t i = 1; i < offsets.size(); ++i)
    {
      const double size = offsets[i] - offsets[i - 1];
      if (!(offsets[i - 1] >= 0.0 && size >= 0.0 &&
            offsets[i] <= static_cast<double>(connectivity.size())))
      {
        refuse("cell " + std::to_string(i - 1) + " does not fit into CONNECTIVITY");
      }
      addCell(connectivity.data() + static_cast<std::size_t>(offsets[i - 1]),
        static_cast<std::size_t>(size), add);
    }
  }

  void addCell(const double* ids, std::size_t count, Add add)
  {
    std::vector<std::int64_t> pointIds;
    for (std::size_t i = 0; i < count; ++i)
    {
      // Beyond this a double cannot hold an exact id, and no file has so many points.
      pointIds.push_back(std::abs(ids[i]) < 9e15 ? static_cast<std::int64_t>(ids[i]) : -1);
    }
    if (!pointIds.empty())
    {
      (soup_.*add)(pointIds, 0);
    }
  }

  void skipParagraph()
  {
    while (text_.nextLine() && !TextCursor(text_).wordOnLine().empty())
    {
    }
  }

  void skipField()
  {
    text_.wordOnLine(); // its name
    const std::int64_t arrays = readCount();
    for (std::int64_t i = 0; i < arrays; ++i)
    {
      text_.word(); // the array's name
      const std::int64_t components = readCount();
      const std::int64_t tuples = readCount();
      readNumbers(components * tuples, readType(), "FIELD");
    }
  }

  TextCursor text_;
  std::int64_t largestCount_; // upper limit of counts: every number takes at least one byte
  Encoding encoding_ = Encoding::Text;
  SoupBuilder soup_;
};

} // namespace

MeshInput parseLegacyVtk(const std::string& content)
{
  return LegacyVtkParser(content).parse();
}

} // namespace medial
