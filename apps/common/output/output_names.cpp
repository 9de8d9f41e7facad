#include "output/output_names.h"

#include "failure.h"
#include "input/input_file.h"
#include "output/standard_output.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace medial::app
{
namespace
{

/// Where a file is, or will be: the same for all spellings of its name.
fs::path placeOf(const fs::path& file)
{
  // A name that does not exist stays relative unless it is made absolute first.
  std::error_code error; // the current folder may be gone
  const fs::path whole = fs::absolute(file.empty() ? fs::path(".") : file, error);
  fs::path place = error ? fs::path() : fs::weakly_canonical(whole, error);
  return error ? file.lexically_normal() : place;
}

bool isSame(const fs::path& a, const fs::path& b)
{
  std::error_code ignored;
  return placeOf(a) == placeOf(b) || fs::equivalent(a, b, ignored);
}

/// An output with what has to be looked up only once.
struct Candidate
{
  explicit Candidate(const NamedOutput& named)
    : output(named)
    , links(named.series ? named.series->links() : std::vector<fs::path>())
  {
  }

  /// The file of the output that would be written to the place of `file`.
  std::optional<fs::path> at(const fs::path& file) const
  {
    if (output.isFile && isSame(output.path, file))
    {
      return output.path;
    }
    const auto link = std::find_if(links.begin(), links.end(),
      [&](const fs::path& one) { return isSame(one, file); });
    if (link != links.end())
    {
      return *link;
    }
    return output.series && output.series->has(file) ? std::optional(file) : std::nullopt;
  }

  const NamedOutput& output;
  std::vector<fs::path> links;
};

std::vector<Candidate> candidatesOf(const std::vector<NamedOutput>& outputs)
{
  std::vector<Candidate> wanted;
  for (const NamedOutput& output : outputs)
  {
    if (!output.path.empty() && output.path != kStandardOutput)
    {
      wanted.emplace_back(output);
    }
  }
  return wanted;
}

void checkInput(const Candidate& candidate, const NamedInput& input)
{
  for (const fs::path& read : input.files)
  {
    const std::optional<fs::path> written = candidate.at(read);
    if (!written)
    {
      continue;
    }
    const NamedOutput& output = candidate.output;
    const bool isPiece = *written != output.path;
    throw Failure(ExitCode::Usage,
      std::string(output.option) + " " + output.path.string() +
        (isPiece ? ": its piece " + written->string() : "") +
        (isSame(read, input.path) ? " is the input file itself"
                                  : " is a file of the input " + input.path.string()));
  }
}

/// The file that two outputs have in common.
std::optional<fs::path> sharedBy(const Candidate& a, const Candidate& b)
{
  if (auto file = a.at(b.output.path))
  {
    return file;
  }
  if (auto file = b.at(a.output.path))
  {
    return file;
  }
  const bool meet = a.output.series && b.output.series && a.output.series->meets(*b.output.series);
  return meet ? std::optional(a.output.series->file(0)) : std::nullopt;
}

} // namespace

FileSeries::FileSeries(fs::path folder, std::string before, int digits, std::string after)
  : folder_(std::move(folder))
  , before_(std::move(before))
  , digits_(digits)
  , after_(std::move(after))
{
}

fs::path FileSeries::file(std::size_t number) const
{
  const std::string text = std::to_string(number);
  const auto digits = static_cast<std::size_t>(digits_);
  const std::string zeros(text.size() < digits ? digits - text.size() : 0, '0');
  return folder_ / (before_ + zeros + text + after_);
}

bool FileSeries::hasName(const std::string& name) const
{
  if (name.size() <= before_.size() + after_.size() || name.find(before_) != 0)
  {
    return false;
  }
  const std::string digits =
    name.substr(before_.size(), name.size() - before_.size() - after_.size());
  return digits.find_first_not_of("0123456789") == std::string::npos &&
    this->file(std::strtoull(digits.c_str(), nullptr, 10)).filename() == name;
}

bool FileSeries::has(const fs::path& file) const
{
  const fs::path place = placeOf(file);
  return this->hasName(place.filename().string()) && place.parent_path() == placeOf(folder_);
}

bool FileSeries::meets(const FileSeries& other) const
{
  return before_ == other.before_ && after_ == other.after_ &&
    placeOf(folder_) == placeOf(other.folder_);
}

std::vector<fs::path> FileSeries::links() const
{
  std::vector<fs::path> links;
  std::error_code ignored;
  for (const fs::directory_entry& entry :
    fs::directory_iterator(folder_.empty() ? fs::path(".") : folder_, ignored))
  {
    const std::string name = entry.path().filename().string();
    if (entry.is_symlink(ignored) && this->hasName(name))
    {
      links.push_back(folder_ / name);
    }
  }
  return links;
}

std::optional<FileSeries> piecesOf(const fs::path& path)
{
  constexpr std::array<std::pair<const char*, const char*>, 3> kIndices{ { { ".pvtp", ".vtp" },
    { ".pvd", ".vtp" }, { ".pvti", ".vti" } } };
  const auto* const found = std::find_if(kIndices.begin(), kIndices.end(),
    [extension = extensionOf(path)](const auto& index) { return index.first == extension; });
  return found == kIndices.end()
    ? std::nullopt
    : std::optional(FileSeries(path.parent_path(), path.stem().string() + "_", 1, found->second));
}

fs::path pieceOf(const fs::path& index, std::size_t number)
{
  return piecesOf(index).value().file(number);
}

FileSeries picturesIn(const fs::path& folder)
{
  return { folder, "frame_", 4, ".png" };
}

void checkNames(const std::vector<NamedOutput>& outputs, const std::vector<NamedInput>& inputs)
{
  const std::vector<Candidate> wanted = candidatesOf(outputs);
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    for (const NamedInput& input : inputs)
    {
      checkInput(wanted[i], input);
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if (const auto file = sharedBy(wanted[j], wanted[i]))
      {
        throw Failure(ExitCode::Usage,
          std::string(wanted[j].output.option) + " and " + wanted[i].output.option +
            " name the same file, " + file->string());
      }
    }
  }
}

} // namespace medial::app
