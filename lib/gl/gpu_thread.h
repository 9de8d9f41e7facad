#pragma once

#include "medial/device.h"

#include <functional>
#include <future>
#include <memory>
#include <utility>

namespace medial::gl
{

/// The one thread of the process that uses OpenGL. It has its own context and so never touches a
/// caller's current context. (Where a GLX context is current, as in a VTK window, making an EGL
/// context current on the same thread fails anyway.)
class GpuThread
{
public:
  /// Returns the thread, and starts it on first use.
  /// @throws Error NoGpu if no context can be made; the next call tries again.
  static GpuThread& instance();

  ~GpuThread();
  GpuThread(const GpuThread&) = delete;
  GpuThread& operator=(const GpuThread&) = delete;

  const Device& device() const;

  /// Queues a job. Jobs run one at a time in the order of submission; their exceptions end up in
  /// the future.
  std::future<void> submit(std::function<void()> job);

  /// Runs a job and waits for it. Must not be called from a job.
  void run(std::function<void()> job) { this->submit(std::move(job)).get(); }

private:
  GpuThread();
  struct State;
  std::unique_ptr<State> state_;
};

/// Holds a T that lives on the GPU thread: it is constructed, used through `run` and destroyed
/// there.
template <typename T>
class OnGpuThread
{
public:
  template <typename... Args>
  explicit OnGpuThread(Args&&... args)
    : thread_(GpuThread::instance())
  {
    thread_.run([&] { object_ = std::make_unique<T>(std::forward<Args>(args)...); });
  }
  ~OnGpuThread()
  {
    if (object_)
    {
      thread_.run([this] { object_.reset(); });
    }
  }
  OnGpuThread(const OnGpuThread&) = delete;
  OnGpuThread& operator=(const OnGpuThread&) = delete;

  template <typename F>
  void run(F&& job)
  {
    thread_.run([&] { job(*object_); });
  }

  /// Queues a job, which must end before this object is destroyed.
  template <typename F>
  std::future<void> submit(F&& job)
  {
    return thread_.submit([this, job = std::forward<F>(job)] { job(*object_); });
  }

  /// For jobs that already run on the GPU thread, and for members that need no OpenGL.
  T& object() { return *object_; }

private:
  GpuThread& thread_;
  std::unique_ptr<T> object_;
};

} // namespace medial::gl
