#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// The names of all files that an output consists of.
namespace medial::app
{

/// Files of one folder that have a number in their names.
class FileSeries
{
public:
  /// @param digits that a name has at least; shorter numbers get leading zeros.
  FileSeries(std::filesystem::path folder, std::string before, int digits, std::string after);

  std::filesystem::path file(std::size_t number) const;

  /// Whether a file would be one of the series, by its place and its name.
  bool has(const std::filesystem::path& file) const;
  /// Whether the two have files in common.
  bool meets(const FileSeries& other) const;
  /// Those that exist as symbolic links: what is written to them lands elsewhere.
  std::vector<std::filesystem::path> links() const;

private:
  bool hasName(const std::string& name) const;

  std::filesystem::path folder_;
  std::string before_;
  int digits_;
  std::string after_;
};

/// The pieces of an output: FILE_0.vtp and so on of the indices FILE.pvtp and FILE.pvd, FILE_0.vti
/// of FILE.pvti. Nothing for an output in one file.
std::optional<FileSeries> piecesOf(const std::filesystem::path& path);

/// The pieces of an index.
std::filesystem::path pieceOf(const std::filesystem::path& index, std::size_t number);

/// The pictures of an animation: frame_0000.png and so on.
FileSeries picturesIn(const std::filesystem::path& folder);

/// An output that the user has asked for.
struct NamedOutput
{
  NamedOutput(const char* namedBy, const std::filesystem::path& named)
    : option(namedBy)
    , path(named)
    , series(piecesOf(named))
  {
  }
  /// An output in a folder.
  NamedOutput(const char* namedBy, const std::filesystem::path& folder, const FileSeries& files)
    : option(namedBy)
    , path(folder)
    , isFile(false)
    , series(files)
  {
  }

  const char* option;
  std::filesystem::path path; ///< empty for none
  bool isFile = true;
  std::optional<FileSeries> series; ///< files that it consists of, besides
};

/// An input, and all files that are read because of it.
struct NamedInput
{
  std::filesystem::path path;
  std::vector<std::filesystem::path> files;
};

/// No file of an output may replace an input, or a file of another output. All numbers of pieces
/// count, since it is not known yet how many there will be.
/// @throws Failure Usage naming the options and the file.
void checkNames(const std::vector<NamedOutput>& outputs, const std::vector<NamedInput>& inputs);

} // namespace medial::app
