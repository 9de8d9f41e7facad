#include "output/file_writer.h"

#include "failure.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace medial::app
{

void writeFile(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write)
{
  std::ofstream stream(file, std::ios::binary);
  write(stream);
  if (stream)
  {
    errno = 0; // so that an error found below comes from close()
  }
  stream.close();
  if (!stream)
  {
    throw Failure(ExitCode::NoSpace, errno != 0 ? std::strerror(errno) : "write error");
  }
}

void writeFile(const std::filesystem::path& file, std::string_view bytes)
{
  writeFile(file,
    [bytes](std::ostream& stream)
    { stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size())); });
}

} // namespace medial::app
