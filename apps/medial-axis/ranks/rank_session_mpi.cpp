#include "ranks/rank_session.h"

#include "failure.h"
#include "interrupt.h"
#include "output/output_file.h"
#include "program_main.h"

#ifdef __GLIBC__
#  include <malloc.h>
#endif
#include <mpi.h>
#include <vtkMPICommunicator.h>
#include <vtkMPIController.h>
#include <vtkMedialRanks.h>
#include <vtkNew.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace medial::app
{
namespace
{

/// Whether one of the variables by which launchers tell a process how many there are says several.
bool isOneOfSeveral()
{
  for (const char* name : { "OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE" })
  {
    const char* const value = std::getenv(name);
    if (value != nullptr && std::atoi(value) > 1)
    {
      return true;
    }
  }
  return false;
}

/// Has large blocks of memory go back to the system when they are freed. Each step of a rank frees
/// most of what the one before it took; glibc soon keeps blocks of up to 32 MiB, and their gaps
/// were up to an eighth of the memory.
void returnFreedMemory()
{
#ifdef M_MMAP_THRESHOLD
  constexpr int kLarge = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, kLarge);
#endif
}

/// Messages over a controller of VTK.
class ControllerCommunicator : public Communicator
{
public:
  explicit ControllerCommunicator(vtkMPIController* controller)
    : controller_(controller)
  {
  }

  int rank() const override { return controller_->GetLocalProcessId(); }
  int size() const override { return controller_->GetNumberOfProcesses(); }

  std::vector<Message> exchange(std::vector<Message> messages) override
  {
    return vtkExchangeInPairs(
      this->rank(), std::move(messages),
      [this](const Message& message, int to) { this->send(message, to); },
      [this](int from) { return this->receive(from); });
  }

private:
  static constexpr int kTag = 1806;
  /// Messages of MPI have lengths of 32 bits.
  static constexpr std::size_t kMaxPart = std::size_t{ 1 } << 30;

  void send(const Message& message, int to) const
  {
    const auto length = static_cast<std::int64_t>(message.size());
    this->sendPart(reinterpret_cast<const char*>(&length), sizeof(length), to);
    for (std::size_t first = 0; first < message.size(); first += kMaxPart)
    {
      this->sendPart(message.data() + first, std::min(kMaxPart, message.size() - first), to);
    }
  }

  Message receive(int from) const
  {
    std::int64_t length = 0;
    this->receivePart(reinterpret_cast<char*>(&length), sizeof(length), from);
    Message message(static_cast<std::size_t>(length));
    for (std::size_t first = 0; first < message.size(); first += kMaxPart)
    {
      this->receivePart(message.data() + first, std::min(kMaxPart, message.size() - first), from);
    }
    return message;
  }

  void sendPart(const char* bytes, std::size_t count, int to) const
  {
    vtkMPICommunicator::Request request;
    controller_->NoBlockSend(bytes, static_cast<int>(count), to, kTag, request);
    waitFor([&] { return request.Test() != 0; });
  }

  void receivePart(char* bytes, std::size_t count, int from) const
  {
    int arrived = 0;
    int source = 0;
    waitFor(
      [&]
      {
        controller_->Iprobe(from, kTag, &arrived, &source);
        return arrived != 0;
      });
    controller_->Receive(bytes, static_cast<vtkIdType>(count), from, kTag);
  }

  /// Waits without taking the time of ranks that compute.
  template <typename Done>
  static void waitFor(const Done& done)
  {
    std::chrono::microseconds pause(1);
    while (!done())
    {
      std::this_thread::sleep_for(pause);
      pause = std::min(2 * pause, std::chrono::microseconds(500));
    }
  }

  vtkMPIController* controller_;
};

/// Ends the process where it was asked to stop and has not done so in time: it may wait for a rank
/// that has died, or for one that computes and knows of nothing.
class InterruptWatch
{
public:
  explicit InterruptWatch(int rank)
    : rank_(rank)
    , thread_([this] { this->watch(); })
  {
  }

  ~InterruptWatch()
  {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ended_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

private:
  void watch()
  {
    using Clock = std::chrono::steady_clock;
    constexpr std::chrono::milliseconds kInterval(20);
    constexpr std::chrono::milliseconds kPatience(250);
    std::unique_lock<std::mutex> lock(mutex_);
    for (Clock::time_point asked = Clock::now(); Clock::now() - asked < kPatience;)
    {
      if (changed_.wait_for(lock, kInterval, [this] { return ended_; }))
      {
        return;
      }
      asked = interrupted() ? asked : Clock::now();
    }
    OutputFile::removeTemporaries();
    // Launchers kill all processes after a second, and mpirun as soon as one has ended: by then
    // the others have removed their files, too.
    std::this_thread::sleep_for(kPatience);
    if (!interruptedByParent()) // which has told why, or has another rank that did
    {
      std::fprintf(stderr, "medial-axis: rank %d: interrupted; nothing was written\n", rank_);
    }
    std::_Exit(static_cast<int>(ExitCode::Interrupted));
  }

  int rank_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false;
  std::thread thread_; ///< the last member: it uses the others
};

class MpiSession : public RankSession
{
public:
  MpiSession(int& argc, char**& argv)
  {
    controller_->Initialize(&argc, &argv, 0);
    communicator_ = std::make_unique<ControllerCommunicator>(controller_.Get());
    nameProcess(communicator_->rank());
    if (communicator_->rank() > 0)
    {
      // Answers to --help are the same on all ranks. A failure to open the device loses nothing.
      static_cast<void>(std::freopen("/dev/null", "w", stdout));
    }
    watch_.emplace(communicator_->rank());
  }

  ~MpiSession() override
  {
    watch_.reset();
    controller_->Finalize();
  }

  Communicator& communicator() override { return *communicator_; }

  void run(const std::function<void()>& work) override
  {
    try
    {
      work();
    }
    catch (const Failure&)
    {
      this->reportOnFirst();
      throw;
    }
    catch (const RankFault&)
    {
      this->reportOnFirst();
      throw;
    }
    catch (const std::bad_alloc&)
    {
      this->abort(ExitCode::NoSpace, "", "not enough memory");
    }
    catch (const std::exception& error)
    {
      this->abort(ExitCode::Fault, kFault, error.what());
    }
    catch (...)
    {
      this->abort(ExitCode::Fault, kFault, "an exception of an unknown type");
    }
  }

private:
  static constexpr char kFault[] = "a fault of the program: ";

  /// Every rank has the same failure or fault. The others wait for the line of the first: once one
  /// has ended, launchers kill those that take their time.
  void reportOnFirst()
  {
    if (communicator_->rank() == 0)
    {
      reportException();
    }
    muteReports();
    gathered(*communicator_, {});
  }

  /// Ends all ranks, with a line.
  [[noreturn]] void abort(ExitCode code, const char* kind, const char* message)
  {
    std::fprintf(stderr, "medial-axis: %srank %d: %s\n", kind, communicator_->rank(), message);
    OutputFile::removeTemporaries();
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
    std::_Exit(static_cast<int>(code));
  }

  vtkNew<vtkMPIController> controller_;
  std::unique_ptr<Communicator> communicator_;
  std::optional<InterruptWatch> watch_;
};

} // namespace

std::unique_ptr<RankSession> RankSession::start(int& argc, char**& argv)
{
  if (!isOneOfSeveral())
  {
    return nullptr;
  }
  returnFreedMemory();
  return std::make_unique<MpiSession>(argc, argv);
}

} // namespace medial::app
