#include "ranks/collective.h"

#include <new>
#include <optional>

namespace medial
{

void agree(Communicator& communicator, const std::function<void()>& work)
{
  std::vector<char> failure; // its code, then its message
  const auto fail = [&](ErrorCode code, const std::string& message)
  {
    failure.push_back(static_cast<char>(code));
    failure.insert(failure.end(), message.begin(), message.end());
  };
  try
  {
    work();
  }
  catch (const Error& error)
  {
    fail(error.code(), error.what());
  }
  catch (const std::bad_alloc&)
  {
    fail(ErrorCode::OutOfMemory, "the memory does not suffice");
  }
  const RankLists<char> failures = gathered(communicator, failure);
  for (std::size_t rank = 0; rank < failures.size(); ++rank)
  {
    if (!failures[rank].empty())
    {
      const std::string message(failures[rank].begin() + 1, failures[rank].end());
      throw Error(static_cast<ErrorCode>(failures[rank].front()),
        failures.size() > 1 ? "rank " + std::to_string(rank) + ": " + message : message);
    }
  }
}

} // namespace medial
