#include "validators.h"

namespace medial::app
{

CLI::Validator oneOf(const Names& names)
{
  return CLI::Validator(
    [names](std::string& word)
    {
      if (names.count(word) > 0)
      {
        return std::string();
      }
      std::string allowed;
      for (const auto& name : names)
      {
        allowed += (allowed.empty() ? "" : ", ") + name.first;
      }
      return "'" + word + "' is not one of " + allowed;
    },
    "");
}

} // namespace medial::app
