#include "ranks/axis/global_numbers.h"

#include <algorithm>

namespace medial
{

GlobalNumbers::GlobalNumbers(Communicator& communicator, const std::vector<GlobalKey>& own,
  std::int64_t span)
  : ranks_(communicator.size())
  , span_(std::max<std::int64_t>(span, 1))
  , rank_(communicator.rank())
{
  RankLists<GlobalKey> lists = listsFor<GlobalKey>(communicator);
  for (const GlobalKey& key : own)
  {
    lists[this->homeOfKey(key)].push_back(key);
  }
  kept_ = flattened(exchanged(communicator, std::move(lists)));
  std::sort(kept_.begin(), kept_.end());
  offsets_ = RankOffsets(communicator, static_cast<std::int64_t>(kept_.size()));
}

std::vector<std::int64_t> GlobalNumbers::of(Communicator& communicator,
  const std::vector<GlobalKey>& keys) const
{
  RankLists<GlobalKey> questions = listsFor<GlobalKey>(communicator);
  for (const GlobalKey& key : keys)
  {
    questions[this->homeOfKey(key)].push_back(key);
  }
  questions = exchanged(communicator, std::move(questions));
  RankLists<std::int64_t> answers = listsFor<std::int64_t>(communicator);
  for (std::size_t rank = 0; rank < questions.size(); ++rank)
  {
    for (const GlobalKey& key : questions[rank])
    {
      const auto at = std::lower_bound(kept_.begin(), kept_.end(), key);
      answers[rank].push_back(offsets_.first[rank_] + (at - kept_.begin()));
    }
  }
  answers = exchanged(communicator, std::move(answers));
  std::vector<std::int64_t> numbers;
  std::vector<std::size_t> next(answers.size(), 0);
  for (const GlobalKey& key : keys)
  {
    const int home = this->homeOfKey(key);
    numbers.push_back(answers[home][next[home]++]);
  }
  return numbers;
}

} // namespace medial
