#pragma once

#include <cstdint>
#include <filesystem>

namespace medial::app
{

/// A file that is written in any order, at offsets of 64 bits. Parts that were never written read
/// as zeros. Messages of failures do not name the file.
class PositionedFile
{
public:
  /// @throws Failure NoSpace unless `file` exists and can be written.
  explicit PositionedFile(const std::filesystem::path& file);
  ~PositionedFile();
  PositionedFile(const PositionedFile&) = delete;
  PositionedFile& operator=(const PositionedFile&) = delete;

  /// @throws Failure NoSpace unless everything was written.
  void write(const void* bytes, std::uint64_t count, std::uint64_t offset);

  /// @throws Failure NoSpace if the system reports only now that something was not written.
  void close();

private:
  int descriptor_;
};

} // namespace medial::app
