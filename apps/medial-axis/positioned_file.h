#pragma once

#include <cstdint>
#include <filesystem>

namespace medial::app
{

/// A file that is written at offsets of 64 bits. Messages of failures do not name it.
class ValueFile
{
public:
  virtual ~ValueFile() = default;

  /// @throws Failure NoSpace unless everything was written.
  virtual void write(const void* bytes, std::uint64_t count, std::uint64_t offset) = 0;

  /// @throws Failure NoSpace if the system reports only now that something was not written.
  virtual void close() = 0;
};

/// A file that is written in any order, . Parts that were never written read as zeros.
class PositionedFile : public ValueFile
{
public:
  /// @throws Failure NoSpace unless `file` exists and can be written.
  explicit PositionedFile(const std::filesystem::path& file);
  ~PositionedFile() override;
  PositionedFile(const PositionedFile&) = delete;
  PositionedFile& operator=(const PositionedFile&) = delete;

  void write(const void* bytes, std::uint64_t count, std::uint64_t offset) override;
  void close() override;

private:
  int descriptor_;
};

} // namespace medial::app
