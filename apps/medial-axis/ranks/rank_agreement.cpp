#include "ranks/rank_agreement.h"

#include "failure.h"
#include "interrupt.h"
#include "library_calls.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>

namespace medial::app
{

using Message = Communicator::Message;

void withSharedFailures(Communicator& communicator, const std::function<void()>& work)
{
  Message failure; // exit code, then message
  try
  {
    withFailures(work);
    throwIfInterrupted();
  }
  catch (const Failure& caught)
  {
    failure.push_back(static_cast<char>(caught.exitCode()));
    const std::string text = caught.what();
    failure.insert(failure.end(), text.begin(), text.end());
  }
  const std::vector<Message> failures = gathered(communicator, failure);
  const bool same =
    std::adjacent_find(failures.begin(), failures.end(), std::not_equal_to<>()) == failures.end();
  for (std::size_t rank = 0; rank < failures.size(); ++rank)
  {
    const Message& found = failures[rank];
    if (!found.empty())
    {
      throw Failure(static_cast<ExitCode>(static_cast<unsigned char>(found.front())),
        (same ? "" : "rank " + std::to_string(rank) + ": ") +
          std::string(found.begin() + 1, found.end()));
    }
  }
}

void withFailuresOfFirst(Communicator& communicator, const std::function<void()>& work)
{
  withSharedFailures(communicator,
    [&]
    {
      if (communicator.rank() == 0)
      {
        work();
      }
    });
}

} // namespace medial::app
