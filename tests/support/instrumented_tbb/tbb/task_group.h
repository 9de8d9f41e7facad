#pragma once

#include <exception>
#include <thread>

namespace tbb
{

/// One task at most.
class task_group
{
public:
  task_group() = default;
  task_group(const task_group&) = delete;
  task_group& operator=(const task_group&) = delete;
  ~task_group()
  {
    if (thread_.joinable())
    {
      thread_.join();
    }
  }

  template <typename Task>
  void run(const Task& task)
  {
    thread_ = std::thread(
      [this, task]
      {
        try
        {
          task();
        }
        catch (...)
        {
          error_ = std::current_exception();
        }
      });
  }

  void wait()
  {
    thread_.join();
    if (error_)
    {
      std::rethrow_exception(error_);
    }
  }

private:
  std::thread thread_;
  std::exception_ptr error_;
};

} // namespace tbb
