#include "medial/axis_io.h"

#include "balls/ball_check.h"
#include "io/axis_parsers.h"
#include "io/axis_writers.h"
#include "io/file_reader.h"
#include "io/refusal.h"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <map>
#include <string>

namespace fs = std::filesystem;

namespace medial
{
namespace
{

[[noreturn]] void throwUnknownExtension(ErrorCode code, const fs::path& path)
{
  throw Error(code, "unknown extension '" + extensionOf(path) + "', allowed: .ply .obj .ma");
}

MedialAxis parse(AxisFormat format, const std::string& content)
{
  switch (format)
  {
    case AxisFormat::Ply:
      return parseAxisPly(content);
    case AxisFormat::Obj:
      return parseAxisObj(content);
    case AxisFormat::Ma:
      break;
  }
  return parseAxisMa(content);
}

// errno tells why the system refused a write.
void close(std::ofstream& stream)
{
  if (stream)
  {
    errno = 0;
  }
  stream.close();
  if (!stream)
  {
    throw Error(ErrorCode::CannotWrite, errno != 0 ? std::strerror(errno) : "write error");
  }
}

} // namespace

std::optional<AxisFormat> axisFormatOf(const fs::path& path)
{
  static const std::map<std::string, AxisFormat> kFormats = { { ".ply", AxisFormat::Ply },
    { ".obj", AxisFormat::Obj }, { ".ma", AxisFormat::Ma } };
  const auto found = kFormats.find(extensionOf(path));
  return found == kFormats.end() ? std::nullopt : std::optional(found->second);
}

MedialAxis readAxis(const fs::path& path)
{
  return readFile(path,
    [](const fs::path& file)
    {
      const auto format = axisFormatOf(file);
      if (!format)
      {
        throwUnknownExtension(ErrorCode::CannotRead, file);
      }
      MedialAxis axis = parse(*format, readContent(file));
      if (axis.points.empty())
      {
        refuse("holds no points");
      }
      for (std::size_t i = 0; i < axis.points.size(); ++i)
      {
        checkBall(i, axis.points[i], axis.radius[i]);
      }
      return axis;
    });
}

void writeAxis(const MedialAxis& axis, AxisFormat format, std::ostream& stream)
{
  switch (format)
  {
    case AxisFormat::Ply:
      writeAxisPly(axis, stream);
      break;
    case AxisFormat::Obj:
      writeAxisObj(axis, stream);
      break;
    case AxisFormat::Ma:
      writeAxisMa(axis, stream);
      break;
  }
}

void writeAxis(const MedialAxis& axis, const fs::path& path)
{
  try
  {
    const auto format = axisFormatOf(path);
    if (!format)
    {
      throwUnknownExtension(ErrorCode::CannotWrite, path);
    }
    std::ofstream stream(path, std::ios::binary);
    writeAxis(axis, *format, stream);
    close(stream);
  }
  catch (const Error& error)
  {
    throw Error(error.code(), path.string() + ": cannot be written: " + error.what());
  }
}

} // namespace medial
