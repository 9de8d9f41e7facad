#pragma once

#include "medial/ranks.h"

#include <utility>

namespace medial
{

/// Counts what goes to other ranks, and how often.
class CountingCommunicator : public Communicator
{
public:
  /// @param communicator must outlive this.
  explicit CountingCommunicator(Communicator& communicator)
    : communicator_(communicator)
  {
  }

  int rank() const override { return communicator_.rank(); }
  int size() const override { return communicator_.size(); }
  std::vector<Message> exchange(std::vector<Message> messages) override
  {
    ++exchanges_;
    for (std::size_t to = 0; to < messages.size(); ++to)
    {
      bytesSent_ +=
        static_cast<int>(to) != this->rank() ? static_cast<std::int64_t>(messages[to].size()) : 0;
    }
    return communicator_.exchange(std::move(messages));
  }

  std::int64_t bytesSent() const { return bytesSent_; }
  std::int64_t exchanges() const { return exchanges_; }

private:
  Communicator& communicator_;
  std::int64_t bytesSent_ = 0;
  std::int64_t exchanges_ = 0;
};

} // namespace medial
