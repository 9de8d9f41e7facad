#include "gl/gpu_thread.h"

#include "gl/debug_log.h"
#include "gl/egl_context.h"
#include "gl/fault.h"
#include "gl/shader_program.h"
#include "medial/error.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>

#include <sys/types.h>
#include <unistd.h>

namespace medial
{
namespace gl
{

namespace
{

/// Makes a context and makes it current.
std::unique_ptr<EglContext> makeContext(const std::string& wanted)
{
  if (faultHappens(Fault::ContextRefused))
  {
    throw Error(ErrorCode::NoGpu, "no context can be made");
  }
  const bool debug = wantsDebugOutput();
  auto context = std::make_unique<EglContext>(wanted, debug);
  if (debug)
  {
    captureDebugOutput(context->device());
  }
  return context;
}

} // namespace

/// Work in the queue. Jobs link themselves, so that queueing one allocates nothing.
struct GpuThread::Job
{
  virtual ~Job() = default;
  /// Runs on the GPU thread. The job may be gone afterwards.
  virtual void execute() noexcept = 0;

  Job* next = nullptr;
};

struct GpuThread::State
{
  /// A context, and how many objects were made in it. It is kept for them.
  struct Context
  {
    std::unique_ptr<EglContext> egl;
    int users = 0;
  };

  static thread_local State* here; ///< on the GPU thread
  Device device;
  std::atomic<bool> lost{ false };
  ///@{
  /// GPU thread only.
  std::map<int, Context> contexts; ///< by their numbers
  int number = 0;                  ///< of the current one, if there is one
  ///@}
  std::mutex mutex;
  std::condition_variable wake;
  std::condition_variable finished; ///< a job that someone waits for
  Job* first = nullptr;
  Job* last = nullptr;
  bool stopping = false;
  std::thread thread;
  pid_t process = getpid(); ///< where the thread runs

  bool forked() const { return getpid() != this->process; }

  /// Returns false where no thread would run the job. In a child after fork() even the mutex may be
  /// locked for ever.
  bool enqueue(Job& job)
  {
    if (this->forked())
    {
      return false;
    }
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      if (this->stopping)
      {
        return false;
      }
      (this->last != nullptr ? this->last->next : this->first) = &job;
      this->last = &job;
    }
    this->wake.notify_one();
    return true;
  }

  void work(const std::string& wanted, std::promise<void> started)
  {
    here = this;
    try
    {
      contexts[++number].egl = makeContext(wanted);
    }
    catch (...)
    {
      started.set_exception(std::current_exception());
      return;
    }
    this->device = contexts[number].egl->device();
    started.set_value();
    this->runJobs();
    releaseProgramCache();
    contexts.clear();
  }

  /// Replaces a lost context. Whether that succeeds or not, objects in it are not used any more.
  void replaceLostContext()
  {
    if (!lost)
    {
      return; // another caller was earlier
    }
    releaseProgramCache();
    const int old = number++;
    std::unique_ptr<EglContext> egl;
    std::exception_ptr failure;
    try
    {
      egl = makeContext(std::to_string(device.number));
      if (egl->device().renderer != device.renderer)
      {
        throw Error(ErrorCode::NoGpu, device.renderer + " was lost");
      }
      contexts[number].egl = std::move(egl);
      lost = false;
    }
    catch (...)
    {
      failure = std::current_exception();
    }
    egl.reset();
    this->dropIfUnused(old);
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }

  /// Where a lost context could not be replaced there is none, and OpenGL must not be called.
  void requireContext() const
  {
    if (contexts.count(number) == 0)
    {
      throw ContextLost("the device was reset");
    }
  }

  void dropIfUnused(int context)
  {
    const auto found = contexts.find(context);
    if (context != number && found != contexts.end() && found->second.users == 0)
    {
      contexts.erase(found);
    }
  }

  void runJobs()
  {
    std::unique_lock<std::mutex> lock(this->mutex);
    for (;;)
    {
      this->wake.wait(lock, [this] { return this->stopping || this->first != nullptr; });
      if (this->first == nullptr)
      {
        return;
      }
      Job* job = this->first;
      this->first = job->next;
      this->last = this->first != nullptr ? this->last : nullptr;
      lock.unlock();
      job->execute();
      lock.lock();
    }
  }

  void stop()
  {
    if (this->forked())
    {
      return;
    }
    {
      const std::lock_guard<std::mutex> lock(this->mutex);
      this->stopping = true;
    }
    this->wake.notify_one();
    this->thread.join();
  }

  [[noreturn]] void refuse() const
  {
    throw Error(ErrorCode::NoGpu,
      this->forked()
        ? "this process is a child by fork() of one that uses OpenGL, and so cannot use it; start "
          "children by exec (multiprocessing of Python: start method \"spawn\"), or use the engine "
          "processor"
        : "OpenGL cannot be used any more, since the process is exiting");
  }
};

thread_local GpuThread::State* GpuThread::State::here = nullptr;

GpuThread& GpuThread::instance(const std::string& wanted)
{
  // Never destroyed: objects that were made before it, such as global ones, may ask for it later.
  static GpuThread& thread = *new GpuThread(wanted);
  struct Stopper
  {
    ~Stopper() { thread.state_->stop(); }
  };
  static const Stopper stopAtExit;
  if (!thread.alive())
  {
    thread.state_->refuse();
  }
  if (!answersTo(thread.device(), wanted))
  {
    throw Error(ErrorCode::NoGpu,
      "this process computes on " + thread.device().renderer + ", so it cannot use the device '" +
        wanted + "'");
  }
  thread.replaceLostContext();
  return thread;
}

void GpuThread::replaceLostContext()
{
  if (state_->lost)
  {
    this->runIfAlive([this] { state_->replaceLostContext(); });
  }
}

GpuThread::GpuThread(const std::string& wanted)
  : state_(std::make_unique<State>())
{
  std::promise<void> started;
  std::future<void> ready = started.get_future();
  state_->thread = std::thread(
    [&, promise = std::move(started)]() mutable { state_->work(wanted, std::move(promise)); });
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

GpuThread::~GpuThread() = default;

bool GpuThread::isThisThread()
{
  return State::here != nullptr;
}

int GpuThread::contextNumber()
{
  return State::here != nullptr ? State::here->number : 0;
}

bool GpuThread::isSoftware()
{
  return State::here->device.software;
}

void GpuThread::loseContext()
{
  State::here->lost = true;
}

ContextUse::ContextUse()
  : number_(GpuThread::contextNumber())
{
  GpuThread::State& state = *GpuThread::State::here;
  state.requireContext();
  ++state.contexts.at(number_).users;
}

ContextUse::~ContextUse()
{
  if (GpuThread::State* state = GpuThread::State::here)
  {
    --state->contexts.at(number_).users;
    state->dropIfUnused(number_);
  }
}

void ContextUse::require() const
{
  if (number_ != GpuThread::contextNumber())
  {
    throw ContextLost("the device was reset while another field was computed");
  }
}

bool GpuThread::alive() const
{
  if (state_->forked())
  {
    return false;
  }
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return !state_->stopping;
}

const Device& GpuThread::device() const
{
  return state_->device;
}

std::future<void> GpuThread::submit(std::function<void()> work)
{
  struct Submitted : Job
  {
    std::packaged_task<void()> task;

    void execute() noexcept override
    {
      task();
      delete this;
    }
  };
  auto job = std::make_unique<Submitted>();
  job->task = std::packaged_task<void()>(
    [state = state_.get(), work = std::move(work)]
    {
      state->requireContext();
      work();
    });
  std::future<void> done = job->task.get_future();
  if (!state_->enqueue(*job))
  {
    state_->refuse();
  }
  static_cast<void>(job.release()); // it deletes itself
  return done;
}

void GpuThread::run(const std::function<void()>& work)
{
  const auto inContext = [&]
  {
    state_->requireContext();
    work();
  };
  if (!this->runIfAlive(inContext))
  {
    state_->refuse();
  }
}

bool GpuThread::runIfAlive(const std::function<void()>& work)
{
  struct Awaited : Job
  {
    const std::function<void()>& work;
    State& state;
    std::exception_ptr error;
    bool done = false;

    Awaited(const std::function<void()>& task, State& owner)
      : work(task)
      , state(owner)
    {
    }

    void execute() noexcept override
    {
      try
      {
        work();
      }
      catch (...)
      {
        error = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(state.mutex);
      done = true;
      state.finished.notify_all();
    }
  };
  Awaited job(work, *state_);
  if (!state_->enqueue(job))
  {
    return false;
  }
  {
    std::unique_lock<std::mutex> lock(state_->mutex);
    state_->finished.wait(lock, [&job] { return job.done; });
  }
  if (job.error)
  {
    std::rethrow_exception(job.error);
  }
  return true;
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
