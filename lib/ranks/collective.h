#pragma once

#include "medial/error.h"
#include "medial/ranks.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// What ranks do together. Every rank calls each of these functions.
namespace medial
{

/// A list for each rank, or from each.
template <typename T>
using RankLists = std::vector<std::vector<T>>;

/// The first byte of each message; those that end something have none.
enum class MessageKind : char
{
  Values,
  Failure ///< of the rank that sends it, instead of what the others wait for
};

/// @throws Error on every rank if one of them has sent a failure: that of the first of them, whose
///   name it has unless all have failed alike.
void throwFailureIn(const std::vector<Communicator::Message>& messages);

/// Sends lists[r] to rank r, and returns what each rank sent here. Each list goes as soon as it is
/// copied: the largest ones decide how much memory a rank needs.
/// @throws Error as throwFailureIn().
template <typename T>
RankLists<T> exchanged(Communicator& communicator, RankLists<T> lists)
{
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<Communicator::Message> messages(lists.size());
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    const std::size_t bytes = lists[rank].size() * sizeof(T);
    messages[rank].resize(1 + bytes, static_cast<char>(MessageKind::Values));
    if (bytes > 0)
    {
      std::memcpy(messages[rank].data() + 1, lists[rank].data(), bytes);
    }
    std::vector<T>().swap(lists[rank]);
  }
  messages = communicator.exchange(std::move(messages));
  throwFailureIn(messages);
  RankLists<T> received(messages.size());
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    const std::size_t bytes = messages[rank].size() - 1;
    received[rank].resize(bytes / sizeof(T));
    if (bytes > 0)
    {
      std::memcpy(static_cast<void*>(received[rank].data()), messages[rank].data() + 1, bytes);
    }
    Communicator::Message().swap(messages[rank]);
  }
  return received;
}

/// Returns lists as one, in the order of ranks; each goes as soon as it is copied.
template <typename T>
std::vector<T> flattened(RankLists<T> lists)
{
  std::size_t count = 0;
  for (const std::vector<T>& list : lists)
  {
    count += list.size();
  }
  std::vector<T> result;
  result.reserve(count);
  for (std::vector<T>& list : lists)
  {
    result.insert(result.end(), list.begin(), list.end());
    std::vector<T>().swap(list);
  }
  return result;
}

/// Returns an empty list for each rank.
template <typename T>
RankLists<T> listsFor(const Communicator& communicator)
{
  return RankLists<T>(static_cast<std::size_t>(communicator.size()));
}

/// Returns the lists of all ranks, one for each.
template <typename T>
RankLists<T> gathered(Communicator& communicator, const std::vector<T>& own)
{
  return exchanged(communicator, RankLists<T>(communicator.size(), own));
}

/// Returns the values of all ranks.
template <typename T>
std::vector<T> gathered(Communicator& communicator, const T& own)
{
  std::vector<T> values;
  for (const std::vector<T>& list : gathered(communicator, std::vector<T>{ own }))
  {
    values.push_back(list.front());
  }
  return values;
}

/// Combines lists of the same length, value by value, in the order of ranks.
template <typename T, typename Combine>
std::vector<T> combined(Communicator& communicator, const std::vector<T>& own,
  const Combine& combine)
{
  // Each rank combines its share of the values for all.
  const std::size_t ranks = communicator.size();
  const std::size_t share = (own.size() + ranks - 1) / ranks;
  RankLists<T> parts = listsFor<T>(communicator);
  for (std::size_t rank = 0; rank < ranks; ++rank)
  {
    const std::size_t begin = std::min(rank * share, own.size());
    const std::size_t end = std::min(begin + share, own.size());
    parts[rank].assign(own.begin() + static_cast<std::ptrdiff_t>(begin),
      own.begin() + static_cast<std::ptrdiff_t>(end));
  }
  parts = exchanged(communicator, std::move(parts));
  std::vector<T> sums = parts.front();
  for (std::size_t rank = 1; rank < ranks; ++rank)
  {
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] = combine(sums[i], parts[rank][i]);
    }
  }
  std::vector<T> result;
  for (const std::vector<T>& part : gathered(communicator, sums))
  {
    result.insert(result.end(), part.begin(), part.end());
  }
  return result;
}

/// Sends a list to the first rank, and returns there what all have sent, in the order of ranks.
template <typename T>
std::vector<T> atFirst(Communicator& communicator, std::vector<T> own)
{
  RankLists<T> lists = listsFor<T>(communicator);
  lists.at(0) = std::move(own);
  return flattened(exchanged(communicator, std::move(lists)));
}

/// Sends each item to the rank that homeOf(item) names, and returns what came here, in the order of
/// ranks.
template <typename T, typename HomeOf>
std::vector<T> delivered(Communicator& communicator, const std::vector<T>& items,
  const HomeOf& homeOf)
{
  RankLists<T> lists = listsFor<T>(communicator);
  for (const T& item : items)
  {
    lists[homeOf(item)].push_back(item);
  }
  return flattened(exchanged(communicator, std::move(lists)));
}

/// Returns answers to questions, in their order, from the ranks that homeOf(question) names.
/// @param prepare is called there with the questions, by rank, before they are answered; ranks may
///   do something together in it.
/// @param answerTo returns there the answer to a question.
template <typename Question, typename HomeOf, typename Prepare, typename AnswerTo>
auto answered(Communicator& communicator, const std::vector<Question>& questions,
  const HomeOf& homeOf, const Prepare& prepare, const AnswerTo& answerTo)
{
  using Answer = decltype(answerTo(questions.front()));
  RankLists<Question> lists = listsFor<Question>(communicator);
  for (const Question& question : questions)
  {
    lists[homeOf(question)].push_back(question);
  }
  lists = exchanged(communicator, std::move(lists));
  prepare(lists);
  RankLists<Answer> answers = listsFor<Answer>(communicator);
  for (std::size_t rank = 0; rank < lists.size(); ++rank)
  {
    std::transform(lists[rank].begin(), lists[rank].end(), std::back_inserter(answers[rank]),
      answerTo);
  }
  answers = exchanged(communicator, std::move(answers));
  std::vector<Answer> result;
  std::vector<std::size_t> next(answers.size(), 0);
  for (const Question& question : questions)
  {
    const auto home = static_cast<std::size_t>(homeOf(question));
    result.push_back(answers[home][next[home]++]);
  }
  return result;
}

template <typename Question, typename HomeOf, typename AnswerTo>
auto answered(Communicator& communicator, const std::vector<Question>& questions,
  const HomeOf& homeOf, const AnswerTo& answerTo)
{
  return answered(
    communicator, questions, homeOf, [](const RankLists<Question>& /*asked*/) {}, answerTo);
}

template <typename T>
T maximum(Communicator& communicator, const T& own)
{
  const std::vector<T> values = gathered(communicator, own);
  return *std::max_element(values.begin(), values.end());
}

/// Lets one rank after the other change a value, where the order decides, as that of additions does
/// about the last bits.
/// @param change(value) is called on every rank, in turn.
/// @return what the last rank has made of it, on every rank.
template <typename T, typename Change>
T inTurn(Communicator& communicator, T value, const Change& change)
{
  for (int rank = 0; rank < communicator.size(); ++rank)
  {
    if (rank == communicator.rank())
    {
      change(value);
    }
    value = gathered(communicator, value)[rank];
  }
  return value;
}

/// The numbers of a share when those of all ranks are counted one after the other.
struct RankOffsets
{
  std::vector<std::int64_t> first; ///< of each rank, and the end

  RankOffsets() = default;
  RankOffsets(Communicator& communicator, std::int64_t own)
    : first{ 0 }
  {
    for (const std::int64_t count : gathered(communicator, own))
    {
      first.push_back(first.back() + count);
    }
  }

  std::int64_t total() const { return first.back(); }
  /// Returns the rank that has a number.
  int home(std::int64_t number) const
  {
    return static_cast<int>(std::upper_bound(first.begin(), first.end(), number) - first.begin()) -
      1;
  }
};

/// Returns the rank of an item where `count` of them are shared out evenly.
inline int homeOf(std::int64_t item, std::int64_t count, int ranks)
{
  return static_cast<int>(item / ((count + ranks - 1) / ranks));
}

} // namespace medial
