#pragma once

#include "output/value_file.h"

#include <cstdint>
#include <filesystem>

namespace medial::app
{

/// A file that is written in any order. Parts that were never written read as zeros.
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
