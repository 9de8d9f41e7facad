#include "io/refusal.h"

#include "medial/error.h"

#include <algorithm>

namespace medial
{
namespace
{

// Messages quote files, which may hold anything: what a terminal would obey, or a line of a
// megabyte.
std::string printable(std::string text)
{
  constexpr std::size_t kMaxLength = 300;
  if (text.size() > kMaxLength)
  {
    text.replace(kMaxLength, std::string::npos, "...");
  }
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

} // namespace

void refuse(const std::string& why)
{
  throw Error(ErrorCode::InvalidInput, printable(why));
}

void refuseLine(int line, const std::string& why)
{
  refuse(line > 0 ? "line " + std::to_string(line) + ": " + why : why);
}

} // namespace medial
