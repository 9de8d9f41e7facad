#pragma once

// A stand-in for the part of oneTBB that Medial uses, for ThreadSanitizer. Debian's libtbb is not
// instrumented, so the sanitizer does not see how its threads wait for each other: it reports every
// loop, and suppressing these reports would hide true ones. Here all of it is compiled with the
// sanitizer. Loops run on several threads also on a machine with one core.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace tbb
{
namespace stand_in
{

constexpr int kThreads = 4;

/// How many threads the loops of this thread may use; a task_arena sets it.
inline int& threadLimit()
{
  thread_local int limit = kThreads;
  return limit;
}

/// Threads that help whoever runs a loop.
class Pool
{
public:
  static Pool& instance()
  {
    static Pool pool;
    return pool;
  }

  /// Calls `work` here and on at most `helpers` other threads that are idle, and waits for them.
  void run(int helpers, const std::function<void()>& work)
  {
    Job job{ &work, helpers, 0, nullptr };
    std::unique_lock<std::mutex> lock(mutex_);
    const auto place = jobs_.insert(jobs_.end(), &job);
    // A race shows only where several threads take part, so short loops wait for help that can
    // come.
    const int expected = std::min(helpers, idle_);
    wake_.notify_all();
    changed_.wait_for(lock, kPatience, [&] { return helpers - job.wanted >= expected; });
    lock.unlock();
    call(job, lock);
    jobs_.erase(place);
    changed_.wait(lock, [&job] { return job.running == 0; });
    if (job.error)
    {
      std::rethrow_exception(job.error);
    }
  }

private:
  static constexpr std::chrono::milliseconds kPatience{ 20 };

  struct Job
  {
    const std::function<void()>* work;
    int wanted;  ///< helpers that may still come
    int running; ///< helpers at work
    std::exception_ptr error;
  };

  Pool()
  {
    for (int i = 1; i < kThreads; ++i)
    {
      threads_.emplace_back([this] { help(); });
    }
  }

  ~Pool()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread& thread : threads_)
    {
      thread.join();
    }
  }

  /// Returns with the lock held.
  static void call(Job& job, std::unique_lock<std::mutex>& lock)
  {
    std::exception_ptr error;
    try
    {
      (*job.work)();
    }
    catch (...)
    {
      error = std::current_exception();
    }
    lock.lock();
    if (error && !job.error)
    {
      job.error = error;
    }
  }

  void help()
  {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;)
    {
      const auto next =
        std::find_if(jobs_.begin(), jobs_.end(), [](const Job* job) { return job->wanted > 0; });
      if (next != jobs_.end())
      {
        Job& job = **next;
        --job.wanted;
        ++job.running;
        changed_.notify_all();
        lock.unlock();
        call(job, lock);
        --job.running;
        changed_.notify_all();
      }
      else if (stopping_)
      {
        return;
      }
      else
      {
        ++idle_;
        wake_.wait(lock);
        --idle_;
      }
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  std::condition_variable changed_; ///< a job has more helpers, or fewer
  int idle_ = 0;
  std::list<Job*> jobs_;
  std::vector<std::thread> threads_;
  bool stopping_ = false;
};

/// Calls body(begin, end) for parts of [0, count), in any order. An exception ends it early.
template <typename Body>
void forParts(std::size_t count, const Body& body)
{
  constexpr std::size_t kParts = 16;
  const std::size_t step = std::max<std::size_t>(1, count / kParts);
  std::atomic<std::size_t> next{ 0 };
  const std::function<void()> work = [&]
  {
    try
    {
      for (std::size_t begin = next.fetch_add(step); begin < count; begin = next.fetch_add(step))
      {
        body(begin, std::min(count, begin + step));
        std::this_thread::yield();
      }
    }
    catch (...)
    {
      next = count;
      throw;
    }
  };
  const int limit = threadLimit();
  if (limit <= 1 || count <= 1)
  {
    work();
    return;
  }
  Pool::instance().run(limit - 1, work);
}

} // namespace stand_in
} // namespace tbb
