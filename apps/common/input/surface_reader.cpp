#include "input/surface_reader.h"

#include "input/input_file.h"

#include <utility>
#include <variant>

namespace medial::app
{
namespace
{

/// @param read files::readSurface() or files::readPointSet().
Surface readWith(const std::filesystem::path& path,
  files::SurfaceContent (*read)(const std::filesystem::path&))
{
  files::SurfaceContent content;
  withReaderFailures(path, [&] { content = read(path); });
  return std::visit([](auto& mesh) { return Surface(std::move(mesh)); }, content);
}

} // namespace

Surface readSurface(const std::filesystem::path& path)
{
  return readWith(path, files::readSurface);
}

Surface readPointSet(const std::filesystem::path& path)
{
  return readWith(path, files::readPointSet);
}

} // namespace medial::app
