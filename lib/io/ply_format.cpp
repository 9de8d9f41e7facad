#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/scalar_reader.h"
#include "io/soup_builder.h"
#include "io/text_cursor.h"

#include <cmath>
#include <map>

namespace medial
{
namespace
{

struct Property
{
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::optional<ScalarType> countType; // of a list
};

struct Element
{
  std::string name;
  std::int64_t count = 0;
  std::vector<Property> properties;
};

struct Header
{
  Encoding encoding = Encoding::Text;
  std::vector<Element> elements;
};

ScalarType readType(TextCursor& text)
{
  const std::string_view word = text.wordOnLine();
  const auto type = toScalarType(word);
  if (!type)
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not a type");
  }
  return *type;
}

Encoding readEncoding(TextCursor& text)
{
  const std::string_view word = text.wordOnLine();
  if (word == "ascii")
  {
    return Encoding::Text;
  }
  if (word != "binary_little_endian" && word != "binary_big_endian")
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not an encoding");
  }
  return word == "binary_big_endian" ? Encoding::BigEndian : Encoding::LittleEndian;
}

void readProperty(TextCursor& text, Header& header)
{
  if (header.elements.empty())
  {
    refuseLine(text.line(), "a property before any element");
  }
  Property property;
  TextCursor ahead = text;
  if (ahead.wordOnLine() == "list")
  {
    text = ahead;
    property.countType = readType(text);
  }
  property.type = readType(text);
  property.name = text.wordOnLine();
  header.elements.back().properties.push_back(property);
}

// Reads the header; the cursor is then at the end of the line "end_header".
Header readHeader(TextCursor& text)
{
  if (text.wordOnLine() != "ply")
  {
    refuse("not a PLY file: it does not start with 'ply'");
  }
  Header header;
  while (text.nextLine())
  {
    const std::string_view keyword = text.wordOnLine();
    if (keyword == "end_header")
    {
      return header;
    }
    if (keyword == "format")
    {
      header.encoding = readEncoding(text);
    }
    else if (keyword == "element")
    {
      Element element;
      element.name = text.wordOnLine();
      element.count = toInteger(text.wordOnLine()).value_or(-1);
      if (element.count < 0)
      {
        refuseLine(text.line(), "element '" + element.name + "' has no valid count");
      }
      header.elements.push_back(element);
    }
    else if (keyword == "property")
    {
      readProperty(text, header);
    }
  }
  refuse("ends early: its header has no 'end_header'");
}

// The content of one item of an element: its single values by name, and its list of point indices.
struct Item
{
  std::map<std::string, double> values;
  std::vector<std::int64_t> indices;
};

double require(std::optional<double> value, const Element& element, std::int64_t index)
{
  if (!value)
  {
    refuse("ends early or is damaged: the header promises " + std::to_string(element.count) + " '" +
      element.name + "', number " + std::to_string(index + 1) + " cannot be read");
  }
  return *value;
}

std::int64_t toIndex(double value, const Element& element)
{
  if (!(std::abs(value) < 9e15))
  {
    refuse("an index of element '" + element.name + "' is not a number");
  }
  return static_cast<std::int64_t>(value);
}

void readItem(ScalarReader& values, const Element& element, std::int64_t index, Item& item)
{
  for (const Property& property : element.properties)
  {
    if (!property.countType)
    {
      item.values[property.name] = require(values.next(property.type), element, index);
      continue;
    }
    const std::int64_t count =
      toIndex(require(values.next(*property.countType), element, index), element);
    const bool wanted = property.name == "vertex_indices" || property.name == "vertex_index";
    for (std::int64_t i = 0; i < count; ++i)
    {
      const double value = require(values.next(property.type), element, index);
      if (wanted)
      {
        item.indices.push_back(toIndex(value, element));
      }
    }
  }
}

double coordinate(const Item& item, const char* name)
{
  const auto found = item.values.find(name);
  if (found == item.values.end())
  {
    refuse(std::string("its vertices have no property '") + name + "'");
  }
  return found->second;
}

void keepAttributes(const Item& item, PlyAttributes& attributes)
{
  for (auto& [name, values] : attributes)
  {
    const auto found = item.values.find(name);
    if (found != item.values.end())
    {
      values.push_back(found->second);
    }
  }
}

/// Adds triangle strips; -1 ends one.
void addStrips(const std::vector<std::int64_t>& indices, SoupBuilder& soup)
{
  std::vector<std::int64_t> strip;
  for (const std::int64_t index : indices)
  {
    if (index != -1)
    {
      strip.push_back(index);
      continue;
    }
    soup.addStrip(strip);
    strip.clear();
  }
  soup.addStrip(strip);
}

void addItem(const Element& element, const Item& item, SoupBuilder& soup)
{
  if (element.name == "vertex")
  {
    soup.addPoint(coordinate(item, "x"), coordinate(item, "y"), coordinate(item, "z"));
  }
  else if (element.name == "face")
  {
    soup.addFace(item.indices);
  }
  else if (element.name == "tristrips")
  {
    addStrips(item.indices, soup);
  }
  else if (element.name == "edge")
  {
    soup.addLine({ toIndex(coordinate(item, "vertex1"), element),
      toIndex(coordinate(item, "vertex2"), element) });
  }
}

} // namespace

MeshInput parsePly(const std::string& content, PlyAttributes* attributes)
{
  TextCursor text(content);
  const Header header = readHeader(text);
  ScalarReader values(text, header.encoding);
  SoupBuilder soup;
  for (const Element& element : header.elements)
  {
    Item item;
    const std::int64_t count = element.properties.empty() ? 0 : element.count;
    for (std::int64_t i = 0; i < count; ++i)
    {
      item.indices.clear();
      readItem(values, element, i, item);
      addItem(element, item, soup);
      if (attributes != nullptr && element.name == "vertex")
      {
        keepAttributes(item, *attributes);
      }
    }
  }
  return soup.finish(0);
}

} // namespace medial
