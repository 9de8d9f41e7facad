#pragma once

#include "medial/ranks.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <vector>

namespace medial::test
{

/// Ranks that are threads of one process.
class SimulatedRanks
{
public:
  explicit SimulatedRanks(int size);

  /// Calls work(communicator) on every rank, and returns when all have finished.
  void run(const std::function<void(Communicator&)>& work);

private:
  class Rank;

  std::vector<Communicator::Message> exchange(int rank,
    std::vector<Communicator::Message> messages);
  void wait();

  int size_;
  std::vector<std::vector<Communicator::Message>> messages_;
  std::mutex mutex_;
  std::condition_variable changed_;
  int waiting_ = 0;
  int round_ = 0;
};

} // namespace medial::test
