#pragma once

#include "medial/device.h"

#include <functional>
#include <future>
#include <memory>
#include <string>
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
  /// @param wanted the number of a device or a part of its name; empty for whatever the thread
  ///   uses, at first the best.
  /// @throws Error NoGpu if no context can be made (the next call tries again), if the thread uses
  ///   another device, and where it is not alive().
  static GpuThread& instance(const std::string& wanted = {});

  /// Whether the caller runs on the GPU thread.
  static bool isThisThread();

  ~GpuThread();
  GpuThread(const GpuThread&) = delete;
  GpuThread& operator=(const GpuThread&) = delete;

  /// Whether there is a thread to run jobs. It ends when the process begins to exit, before the
  /// static objects are destroyed that are older than itself; and a child after fork() has no
  /// threads of its parent.
  bool alive() const;

  const Device& device() const;

  /// Queues a job. Jobs run one at a time in the order of submission; their exceptions end up in
  /// the future.
  /// @throws Error NoGpu if the thread is not alive().
  std::future<void> submit(std::function<void()> work);

  /// Runs a job and waits for it. Must not be called from a job.
  /// @throws Error NoGpu if the thread is not alive(), and the job's exceptions.
  void run(const std::function<void()>& work);

  /// As run(), but returns false where the thread is not alive(). Allocates nothing, so destructors
  /// may call it.
  bool runIfAlive(const std::function<void()>& work);

private:
  explicit GpuThread(const std::string& wanted);
  struct Job;
  struct State;
  std::unique_ptr<State> state_;
};

/// Holds a T that lives on the GPU thread: it is constructed, used through `run` and destroyed
/// there. Once that thread is not alive(), T is destroyed by the caller: its memory, that is, since
/// its names of OpenGL went with their context.
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
      thread_.runIfAlive([this] { object_.reset(); });
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
