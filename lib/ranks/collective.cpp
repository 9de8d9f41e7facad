#include "ranks/collective.h"

#include <algorithm>
#include <new>

namespace medial
{
namespace
{

using Message = Communicator::Message;

/// An error that every rank has.
class SharedError : public Error
{
public:
  using Error::Error;
};

/// Sends a failure to all ranks, which wait for something else or have failed too.
/// @throws SharedError.
void fail(Communicator& communicator, ErrorCode code, const std::string& text)
{
  Message message{ static_cast<char>(MessageKind::Failure), static_cast<char>(code) };
  message.insert(message.end(), text.begin(), text.end());
  throwFailureIn(communicator.exchange(
    std::vector<Message>(static_cast<std::size_t>(communicator.size()), message)));
}

} // namespace

void throwFailureIn(const std::vector<Message>& messages)
{
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    const Message& message = messages[rank];
    if (!message.empty() && message.front() == static_cast<char>(MessageKind::Failure))
    {
      const std::string text(message.begin() + 2, message.end());
      const bool everywhere = std::all_of(messages.begin(), messages.end(),
        [&](const Message& other) { return other == message; });
      throw SharedError(static_cast<ErrorCode>(message[1]),
        everywhere ? text : "rank " + std::to_string(rank) + ": " + text);
    }
  }
}

void agreeOn(Communicator& communicator, const std::function<void()>& work)
{
  try
  {
    work();
    // Nothing may fail here once the others know that this rank has not: empty messages take no
    // memory.
    throwFailureIn(
      communicator.exchange(std::vector<Message>(static_cast<std::size_t>(communicator.size()))));
  }
  catch (const SharedError&)
  {
    throw;
  }
  catch (const Error& error)
  {
    fail(communicator, error.code(), error.what());
  }
  catch (const std::bad_alloc&)
  {
    fail(communicator, ErrorCode::OutOfMemory, "the memory does not suffice");
  }
}

} // namespace medial
