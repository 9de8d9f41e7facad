#include "validators.h"

#include <algorithm>

namespace medial::app
{

CLI::Validator oneOf(const std::vector<std::string>& words)
{
  return CLI::Validator(
    [words](std::string& word)
    {
      if (std::find(words.begin(), words.end(), word) != words.end())
      {
        return std::string();
      }
      std::string allowed;
      for (const std::string& one : words)
      {
        allowed += (allowed.empty() ? "" : ", ") + one;
      }
      return "'" + word + "' is not one of " + allowed;
    },
    "");
}

} // namespace medial::app
