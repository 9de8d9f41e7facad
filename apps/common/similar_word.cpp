#include "similar_word.h"

#include <algorithm>
#include <cstddef>

namespace medial::app
{
namespace
{

/// The least number of such changes that turn one word into the other, none touching a letter
/// twice.
std::size_t changesBetween(const std::string& one, const std::string& other)
{
  // changes[i][j]: of the first i letters into the first j.
  std::vector<std::vector<std::size_t>> changes(one.size() + 1,
    std::vector<std::size_t>(other.size() + 1));
  for (std::size_t i = 0; i <= one.size(); ++i)
  {
    for (std::size_t j = 0; j <= other.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        changes[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = changes[i - 1][j - 1] + (one[i - 1] == other[j - 1] ? 0 : 1);
      changes[i][j] = std::min({ replaced, changes[i - 1][j] + 1, changes[i][j - 1] + 1 });
      if (i > 1 && j > 1 && one[i - 1] == other[j - 2] && one[i - 2] == other[j - 1])
      {
        changes[i][j] = std::min(changes[i][j], changes[i - 2][j - 2] + 1);
      }
    }
  }
  return changes[one.size()][other.size()];
}

} // namespace

std::string similarWord(const std::string& word, const std::vector<std::string>& known)
{
  constexpr std::size_t kLongest = 64; // no option is longer, and the work grows with the square
  if (word.empty() || word.size() > kLongest)
  {
    return "";
  }
  std::string started;
  int starts = 0;
  std::string closest;
  std::size_t fewest = word.size() / 3 + 1;
  for (const std::string& candidate : known)
  {
    if (candidate.compare(0, word.size(), word) == 0)
    {
      started = candidate;
      ++starts;
    }
    const std::size_t changes = changesBetween(word, candidate);
    if (changes < fewest)
    {
      fewest = changes;
      closest = candidate;
    }
  }
  return starts == 1 ? started : closest;
}

} // namespace medial::app
