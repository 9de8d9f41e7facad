#include "rank_session.h"

#include "failure.h"
#include "output_file.h"
#include "program_main.h"

#include <mpi.h>
#include <vtkMPIController.h>
#include <vtkNew.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
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

/// Messages over a controller of VTK.
class ControllerCommunicator : public Communicator
{
public:
  explicit ControllerCommunicator(vtkMultiProcessController* controller)
    : controller_(controller)
  {
  }

  int rank() const override { return controller_->GetLocalProcessId(); }
  int size() const override { return controller_->GetNumberOfProcesses(); }

  std::vector<Message> exchange(std::vector<Message> messages) override
  {
    std::vector<Message> received(messages.size());
    const int own = this->rank();
    for (int round = 0; round < this->size(); ++round)
    {
      // In each round every rank talks to one other, and the lower one sends first: none waits
      // for one that waits for it.
      const int other = (round - own + this->size()) % this->size();
      if (other == own)
      {
        received[own] = std::move(messages[own]);
      }
      else if (own < other)
      {
        this->send(messages[other], other);
        received[other] = this->receive(other);
      }
      else
      {
        received[other] = this->receive(other);
        this->send(messages[other], other);
      }
      Message().swap(messages[other]);
    }
    return received;
  }

private:
  static constexpr int kTag = 1806;
  /// Messages of MPI have lengths of 32 bits.
  static constexpr std::size_t kMaxPart = std::size_t{ 1 } << 30;

  void send(const Message& message, int to) const
  {
    const auto length = static_cast<vtkIdType>(message.size());
    controller_->Send(&length, 1, to, kTag);
    for (std::size_t first = 0; first < message.size(); first += kMaxPart)
    {
      controller_->Send(message.data() + first,
        static_cast<vtkIdType>(std::min(kMaxPart, message.size() - first)), to, kTag);
    }
  }

  Message receive(int from) const
  {
    vtkIdType length = 0;
    controller_->Receive(&length, 1, from, kTag);
    Message message(static_cast<std::size_t>(length));
    for (std::size_t first = 0; first < message.size(); first += kMaxPart)
    {
      controller_->Receive(message.data() + first,
        static_cast<vtkIdType>(std::min(kMaxPart, message.size() - first)), from, kTag);
    }
    return message;
  }

  vtkMultiProcessController* controller_;
};

class MpiSession : public RankSession
{
public:
  MpiSession(int& argc, char**& argv)
  {
    controller_->Initialize(&argc, &argv, 0);
    communicator_ = std::make_unique<ControllerCommunicator>(controller_.Get());
    if (communicator_->rank() > 0)
    {
      // Answers to --help are the same on all ranks. A failure to open the device loses nothing.
      static_cast<void>(std::freopen("/dev/null", "w", stdout));
    }
  }

  ~MpiSession() override { controller_->Finalize(); }

  Communicator& communicator() override { return *communicator_; }

  void run(const std::function<void()>& work) override
  {
    try
    {
      work();
    }
    catch (const Failure&)
    {
      // Every rank has the same.
      muteReports(communicator_->rank() > 0);
      throw;
    }
    catch (const std::exception& error)
    {
      this->abort(error.what());
    }
    catch (...)
    {
      this->abort("an exception of an unknown type");
    }
  }

private:
  [[noreturn]] void abort(const char* message)
  {
    std::fprintf(stderr, "medial-axis: a fault of the program: rank %d: %s\n",
      communicator_->rank(), message);
    OutputFile::removeTemporaries();
    MPI_Abort(MPI_COMM_WORLD, static_cast<int>(ExitCode::Fault));
    std::_Exit(static_cast<int>(ExitCode::Fault));
  }

  vtkNew<vtkMPIController> controller_;
  std::unique_ptr<Communicator> communicator_;
};

} // namespace

std::unique_ptr<RankSession> RankSession::start(int& argc, char**& argv)
{
  return isOneOfSeveral() ? std::make_unique<MpiSession>(argc, argv) : nullptr;
}

} // namespace medial::app
