#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/soup_builder.h"
#include "io/text_cursor.h"

namespace medial
{
namespace
{

void readPoint(TextCursor& text, SoupBuilder& soup)
{
  double xyz[3];
  for (double& value : xyz)
  {
    const std::string_view word = text.wordOnLine();
    const auto number = toDouble(word);
    if (!number)
    {
      refuseLine(text.line(), "'" + std::string(word) + "' is not a coordinate");
    }
    value = *number;
  }
  soup.addPoint(xyz[0], xyz[1], xyz[2]);
}

// Reads point ids as "i", "i/t", "i//n" or "i/t/n". OBJ counts from 1; negative ids count
// backwards.
std::vector<std::int64_t> readPointIds(TextCursor& text, const SoupBuilder& soup)
{
  std::vector<std::int64_t> ids;
  for (std::string_view word = text.wordOnLine(); !word.empty(); word = text.wordOnLine())
  {
    const auto index = toInteger(word.substr(0, word.find('/')));
    if (!index || *index == 0 || *index < -soup.pointCount())
    {
      refuseLine(text.line(), "'" + std::string(word) + "' names no point");
    }
    ids.push_back(*index > 0 ? *index - 1 : soup.pointCount() + *index);
  }
  return ids;
}

} // namespace

MeshInput parseObj(const std::string& content)
{
  SoupBuilder soup;
  TextCursor text(content);
  do
  {
    const std::string_view keyword = text.wordOnLine();
    if (keyword == "v")
    {
      readPoint(text, soup);
    }
    else if (keyword == "f")
    {
      soup.addFace(readPointIds(text, soup), text.line());
    }
    else if (keyword == "l")
    {
      soup.addLine(readPointIds(text, soup), text.line());
    }
    else if (keyword == "p")
    {
      soup.addVertices(readPointIds(text, soup), text.line());
    }
  } while (text.nextLine());
  return soup.finish(1);
}

} // namespace medial
