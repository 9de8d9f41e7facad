#include "ranks/collective.h"

#include <algorithm>
#include <exception>
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

/// Stands in messages for the code of what is no Error.
constexpr char kNoCode = -1;

/// Sends a failure to all ranks, which wait for something else or have failed too.
/// @param code an ErrorCode, or kNoCode.
/// @throws SharedError or RankFault.
void fail(Communicator& communicator, char code, const std::string& text)
{
  Message message{ static_cast<char>(MessageKind::Failure), code };
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
      const bool everywhere = std::all_of(messages.begin(), messages.end(),
        [&](const Message& other) { return other == message; });
      const std::string text = (everywhere ? "" : "rank " + std::to_string(rank) + ": ") +
        std::string(message.begin() + 2, message.end());
      if (message[1] == kNoCode)
      {
        throw RankFault(text);
      }
      throw SharedError(static_cast<ErrorCode>(message[1]), text);
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
  catch (const RankFault&)
  {
    throw;
  }
  catch (const Error& error)
  {
    fail(communicator, static_cast<char>(error.code()), error.what());
  }
  catch (const std::bad_alloc&)
  {
    fail(communicator, static_cast<char>(ErrorCode::OutOfMemory), "the memory does not suffice");
  }
  catch (const std::exception& error)
  {
    fail(communicator, kNoCode, error.what());
  }
  catch (...)
  {
    fail(communicator, kNoCode, "an exception of an unknown type");
  }
}

std::vector<Message> gathered(Communicator& communicator, const Message& own)
{
  return exchanged(communicator, RankLists<char>(communicator.size(), own));
}

} // namespace medial
