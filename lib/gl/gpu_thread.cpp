#include "gl/gpu_thread.h"

#include "gl/debug_log.h"
#include "gl/egl_context.h"
#include "gl/shader_program.h"

#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <thread>

namespace medial
{
namespace gl
{

struct GpuThread::State
{
  Device device;
  std::mutex mutex;
  std::condition_variable wake;
  std::deque<std::packaged_task<void()>> jobs;
  bool stopping = false;
  std::thread thread;

  void work(std::promise<void> started)
  {
    std::unique_ptr<EglContext> context;
    try
    {
      const bool debug = std::getenv("MEDIAL_GL_DEBUG") != nullptr;
      context = std::make_unique<EglContext>(debug);
      if (debug)
      {
        captureDebugOutput();
      }
    }
    catch (...)
    {
      started.set_exception(std::current_exception());
      return;
    }
    this->device = context->device();
    started.set_value();
    this->runJobs();
    releaseProgramCache();
  }

  void runJobs()
  {
    std::unique_lock<std::mutex> lock(this->mutex);
    for (;;)
    {
      this->wake.wait(lock, [this] { return this->stopping || !this->jobs.empty(); });
      if (this->jobs.empty())
      {
        return;
      }
      std::packaged_task<void()> job = std::move(this->jobs.front());
      this->jobs.pop_front();
      lock.unlock();
      job();
      lock.lock();
    }
  }
};

GpuThread& GpuThread::instance()
{
  static GpuThread thread;
  return thread;
}

GpuThread::GpuThread()
  : state_(std::make_unique<State>())
{
  std::promise<void> started;
  std::future<void> ready = started.get_future();
  state_->thread = std::thread(
    [this, promise = std::move(started)]() mutable { state_->work(std::move(promise)); });
  try
  {
    ready.get();
  }
  catch (...)
  {
    state_->thread.join();
    throw;
  }
}

GpuThread::~GpuThread()
{
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->stopping = true;
  }
  state_->wake.notify_one();
  state_->thread.join();
}

const Device& GpuThread::device() const
{
  return state_->device;
}

std::future<void> GpuThread::submit(std::function<void()> job)
{
  std::packaged_task<void()> task(std::move(job));
  std::future<void> done = task.get_future();
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->jobs.push_back(std::move(task));
  }
  state_->wake.notify_one();
  return done;
}

} // namespace gl

Device queryDevice()
{
  return gl::GpuThread::instance().device();
}

std::string deviceDebugLog()
{
  return gl::debugLog();
}

} // namespace medial
