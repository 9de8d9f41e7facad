#include "message_of_ranks.h"

#include "simulated_ranks.h"
#include "support/errors.h"

#include <gtest/gtest.h>

#include <vector>

namespace medial::test
{

std::string messageOfRanks(int ranks, const std::function<void(Communicator&)>& work)
{
  std::vector<std::string> messages(ranks);
  SimulatedRanks(ranks).run([&](Communicator& communicator)
    { messages[communicator.rank()] = messageOf([&] { work(communicator); }); });
  EXPECT_EQ(messages, std::vector<std::string>(ranks, messages.front()));
  return messages.front();
}

} // namespace medial::test
