#include "help_formatter.h"

#include <sstream>

namespace medial::app
{
namespace
{

constexpr std::size_t kOptionColumn = 26;
constexpr std::size_t kDescriptionWidth = 70;

} // namespace

HelpFormatter::HelpFormatter()
{
  column_width(kOptionColumn);
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const
{
  std::istringstream words(option->get_description());
  std::string text;
  std::size_t lineLength = 0;
  for (std::string word; words >> word; lineLength += word.size() + 1)
  {
    const bool breakLine = lineLength + word.size() > kDescriptionWidth;
    if (!text.empty())
    {
      text += breakLine ? '\n' : ' ';
    }
    lineLength = breakLine ? 0 : lineLength;
    text += word;
  }
  return text;
}

} // namespace medial::app
