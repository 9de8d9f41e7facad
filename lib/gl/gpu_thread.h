#pragma once

#include "gl/context_lost.h"
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
/// context current on the same thread fails anyway.) A context that is lost is replaced as soon as
/// someone asks for the thread.
class GpuThread
{
public:
  /// Returns the thread, and starts it on first use. Replaces its context, if that was lost, by a
  /// new one on the same device.
  /// @param wanted the number of a device or a part of its name; empty for whatever the thread
  ///   uses, at first the best.
  /// @throws Error NoGpu if no context can be made (the next call tries again), if the thread uses
  ///   another device, and where it is not alive().
  static GpuThread& instance(const std::string& wanted = {});

  /// Whether the caller runs on the GPU thread.
  static bool isThisThread();
  /// The number of the context on the GPU thread, from 1 on; to be called there. (On other threads
  /// it is 0.) Objects belong to one context.
  static int contextNumber();
  /// Whether the GPU thread, which must be the caller, computes on a software renderer.
  static bool isSoftware();
  /// Notes that the context is lost. GPU thread only.
  static void loseContext();

  ~GpuThread();
  GpuThread(const GpuThread&) = delete;
  GpuThread& operator=(const GpuThread&) = delete;

  /// Whether there is a thread to run jobs. It ends when the process begins to exit, before the
  /// static objects are destroyed that are older than itself; and a child after fork() has no
  /// threads of its parent.
  bool alive() const;

  const Device& device() const;

  /// Queues a job. Jobs run one at a time in the order of submission; their exceptions end up in
  /// the future, and ContextLost where a lost context could not be replaced.
  /// @throws Error NoGpu if the thread is not alive().
  std::future<void> submit(std::function<void()> work);

  /// Runs a job and waits for it. Must not be called from a job.
  /// @throws Error NoGpu if the thread is not alive(), ContextLost where a lost context could not
  /// be
  ///   replaced, and the job's exceptions.
  void run(const std::function<void()>& work);

  /// As run(), but returns false where the thread is not alive(). Allocates nothing, so destructors
  /// may call it.
  bool runIfAlive(const std::function<void()>& work);

private:
  friend class ContextUse;
  explicit GpuThread(const std::string& wanted);
  void replaceLostContext();
  struct Job;
  struct State;
  std::unique_ptr<State> state_;
};

/// Keeps the context of the GPU thread while it lives, even if that is lost and replaced: others
/// may still read its mapped buffers. GPU thread only; elsewhere it may be destroyed where that
/// thread is not alive().
class ContextUse
{
public:
  /// @throws ContextLost where there is no context.
  ContextUse();
  ~ContextUse();
  ContextUse(const ContextUse&) = delete;
  ContextUse& operator=(const ContextUse&) = delete;

  /// @throws ContextLost if the context was replaced.
  void require() const;

private:
  int number_;
};

/// Holds a T that lives on the GPU thread: it is constructed, used through `run` and destroyed
/// there, in one context. Once that thread is not alive(), T is destroyed by the caller: its
/// memory, that is, since its names of OpenGL went with their context.
template <typename T>
class OnGpuThread
{
public:
  template <typename... Args>
  explicit OnGpuThread(Args&&... args)
    : thread_(GpuThread::instance())
  {
    thread_.run([&] { held_ = std::make_unique<Held>(std::forward<Args>(args)...); });
  }
  ~OnGpuThread()
  {
    if (held_)
    {
      thread_.runIfAlive([this] { held_.reset(); });
    }
  }
  OnGpuThread(const OnGpuThread&) = delete;
  OnGpuThread& operator=(const OnGpuThread&) = delete;

  /// Runs a job and waits for it.
  /// @throws ContextLost if the object's context was lost and replaced, and as GpuThread::run().
  template <typename F>
  void run(F&& job)
  {
    thread_.run([&] { job(held_->current()); });
  }

  /// Queues a job, which must end before this object is destroyed. Exceptions are those of run().
  template <typename F>
  std::future<void> submit(F&& job)
  {
    return thread_.submit([this, job = std::forward<F>(job)] { job(held_->current()); });
  }

  /// For jobs that already run on the GPU thread, and for members that need no OpenGL.
  T& object() { return held_->object; }

private:
  struct Held
  {
    template <typename... Args>
    explicit Held(Args&&... args)
      : object(std::forward<Args>(args)...)
    {
    }
    T& current()
    {
      use.require();
      return object;
    }

    ContextUse use;
    T object;
  };

  GpuThread& thread_;
  std::unique_ptr<Held> held_;
};

} // namespace medial::gl
