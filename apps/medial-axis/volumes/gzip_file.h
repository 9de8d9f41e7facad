#pragma once

#include "volumes/positioned_file.h"

#include <filesystem>

struct gzFile_s;

namespace medial::app
{

/// A file that is compressed by gzip while it is written, from its start to its end.
class GzipFile : public ValueFile
{
public:
  /// @throws Failure NoSpace unless `file` can be written.
  explicit GzipFile(const std::filesystem::path& file);
  ~GzipFile() override;
  GzipFile(const GzipFile&) = delete;
  GzipFile& operator=(const GzipFile&) = delete;

  /// @param offset where the bytes before have ended.
  void write(const void* bytes, std::uint64_t count, std::uint64_t offset) override;
  void close() override;

private:
  gzFile_s* file_;
  std::uint64_t position_ = 0;
};

} // namespace medial::app
