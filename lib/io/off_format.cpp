#include "io/mesh_formats.h"
#include "io/refusal.h"
#include "io/soup_builder.h"
#include "io/text_cursor.h"

namespace medial
{
namespace
{

double readCoordinate(TextCursor& text, std::string_view word)
{
  const auto number = toDouble(word);
  if (!number)
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not a coordinate");
  }
  return *number;
}

std::int64_t readCount(TextCursor& text, std::string_view word)
{
  const auto number = toInteger(word);
  if (!number || *number < 0)
  {
    refuseLine(text.line(), "'" + std::string(word) + "' is not a count");
  }
  return *number;
}

[[noreturn]] void refuseEarlyEnd(const char* what, std::int64_t wanted, std::int64_t found)
{
  refuse("ends early: the header promises " + std::to_string(wanted) + " " + what +
    ", the file has " + std::to_string(found));
}

void readPoints(TextCursor& text, std::int64_t count, SoupBuilder& soup)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::string_view x = text.word();
    if (x.empty())
    {
      refuseEarlyEnd("vertices", count, i);
    }
    double xyz[3] = { readCoordinate(text, x), 0.0, 0.0 };
    xyz[1] = readCoordinate(text, text.wordOnLine());
    xyz[2] = readCoordinate(text, text.wordOnLine());
    soup.addPoint(xyz[0], xyz[1], xyz[2]);
    text.nextLine(); // normals and colours
  }
}

void readFaces(TextCursor& text, std::int64_t count, SoupBuilder& soup)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    const std::string_view first = text.word();
    if (first.empty())
    {
      refuseEarlyEnd("faces", count, i);
    }
    const std::int64_t corners = readCount(text, first);
    std::vector<std::int64_t> ids;
    while (static_cast<std::int64_t>(ids.size()) < corners)
    {
      const std::string_view word = text.wordOnLine();
      const auto id = toInteger(word);
      if (!id)
      {
        refuseLine(text.line(),
          "a face of " + std::to_string(corners) + " corners lists " + std::to_string(ids.size()));
      }
      ids.push_back(*id);
    }
    soup.addFace(ids, text.line());
    text.nextLine(); // colours
  }
}

} // namespace

MeshInput parseOff(const std::string& content)
{
  SoupBuilder soup;
  TextCursor text(content);
  const std::string_view magic = text.word();
  if (magic.size() < 3 || magic.substr(magic.size() - 3) != "OFF" ||
    magic.find_first_of("4n") != std::string_view::npos)
  {
    refuse("not a three-dimensional OFF file: it starts with '" + std::string(magic.substr(0, 20)) +
      "'");
  }
  const std::string_view first = text.word();
  if (first == "BINARY")
  {
    refuse("binary OFF files are not supported; text ones are");
  }
  const std::int64_t points = readCount(text, first);
  const std::int64_t faces = readCount(text, text.word());
  text.nextLine(); // the number of edges
  readPoints(text, points, soup);
  readFaces(text, faces, soup);
  return soup.finish(0);
}

} // namespace medial
