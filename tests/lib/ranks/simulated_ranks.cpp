#include "simulated_ranks.h"

#include <exception>
#include <new>
#include <thread>
#include <utility>

namespace medial::test
{

class SimulatedRanks::Rank : public Communicator
{
public:
  Rank(SimulatedRanks& ranks, int rank)
    : ranks_(ranks)
    , rank_(rank)
  {
  }

  int rank() const override { return rank_; }
  int size() const override { return ranks_.size_; }
  std::vector<Message> exchange(std::vector<Message> messages) override
  {
    return ranks_.exchange(rank_, std::move(messages));
  }

private:
  SimulatedRanks& ranks_;
  int rank_;
};

SimulatedRanks::SimulatedRanks(int size)
  : size_(size)
  , messages_(size)
{
}

void SimulatedRanks::run(const std::function<void(Communicator&)>& work)
{
  std::vector<std::thread> threads;
  for (int i = 0; i < size_; ++i)
  {
    threads.emplace_back(
      [this, i, &work]
      {
        Rank rank(*this, i);
        work(rank);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

void SimulatedRanks::wait()
{
  std::unique_lock<std::mutex> lock(mutex_);
  const int round = round_;
  if (++waiting_ == size_)
  {
    waiting_ = 0;
    ++round_;
    changed_.notify_all();
    return;
  }
  changed_.wait(lock, [&] { return round_ != round; });
}

std::vector<Communicator::Message> SimulatedRanks::exchange(int rank,
  std::vector<Communicator::Message> messages)
{
  std::vector<Communicator::Message> received;
  received.reserve(messages.size());
  messages_[rank] = std::move(messages);
  this->wait();
  std::exception_ptr failure; // the others do not wait for ever
  try
  {
    for (int from = 0; from < size_; ++from)
    {
      received.push_back(messages_[from][rank]);
    }
  }
  catch (const std::bad_alloc&)
  {
    failure = std::current_exception();
  }
  this->wait();
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return received;
}

} // namespace medial::test
