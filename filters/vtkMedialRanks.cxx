#include "vtkMedialRanks.h"

#include "vtkMultiProcessController.h"

#include "medial/error.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>
#include <sstream>
#include <utility>

namespace
{

constexpr int MessageTag = 18064;
// Messages of MPI have lengths of 32 bits.
constexpr std::size_t LargestPart = std::size_t{ 1 } << 30;
constexpr std::size_t FirstPart = 4096;

using Message = medial::Communicator::Message;

//------------------------------------------------------------------------------
// What a rank says where ranks meet: this, then Text.
struct Report
{
  vtkMedialRanks::Stage Stage;
  bool Failed;
  medial::ErrorCode Code;
  vtkPieceFacts Facts;
};

//------------------------------------------------------------------------------
struct FullReport : Report
{
  std::string Text; // what failed, or the options

  Message ToMessage() const
  {
    const Report& head = *this;
    Message message(sizeof(head));
    std::memcpy(message.data(), &head, sizeof(head));
    message.insert(message.end(), this->Text.begin(), this->Text.end());
    return message;
  }

  static FullReport Of(const Message& message)
  {
    FullReport report;
    Report& head = report;
    std::memcpy(static_cast<void*>(&head), message.data(), sizeof(head));
    report.Text.assign(message.begin() + sizeof(head), message.end());
    return report;
  }
};

//------------------------------------------------------------------------------
// Does the work of a rank.
FullReport Try(vtkMedialRanks::Stage stage, const std::string& options,
  const std::function<vtkPieceFacts()>& work)
{
  FullReport report{ { stage, false, medial::ErrorCode::InvalidInput, {} }, options };
  const auto fail = [&](medial::ErrorCode code, const char* message)
  {
    report.Failed = true;
    report.Code = code;
    report.Text = message;
  };
  try
  {
    report.Facts = work();
  }
  catch (const medial::Error& error)
  {
    fail(error.code(), error.what());
  }
  catch (const std::bad_alloc&)
  {
    fail(medial::ErrorCode::OutOfMemory, "not enough memory for the result");
  }
  return report;
}

//------------------------------------------------------------------------------
[[noreturn]] void ThrowOf(std::size_t rank, std::size_t ranks, medial::ErrorCode code,
  const std::string& message)
{
  throw medial::Error(code, ranks > 1 ? "rank " + std::to_string(rank) + ": " + message : message);
}

//------------------------------------------------------------------------------
// Where lines differ; those that only one has do not count, as ranks may be at different stages.
void RequireSameOptions(const std::vector<FullReport>& reports)
{
  for (std::size_t rank = 1; rank < reports.size(); ++rank)
  {
    std::istringstream expected(reports.front().Text);
    std::istringstream found(reports[rank].Text);
    std::string theirs;
    std::string here;
    while (std::getline(expected, theirs) && std::getline(found, here))
    {
      if (here != theirs)
      {
        ThrowOf(rank, reports.size(), medial::ErrorCode::InvalidInput,
          here.append(", but rank 0 has ").append(theirs));
      }
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
int vtkMedialRanks::rank() const
{
  return this->Controller ? this->Controller->GetLocalProcessId() : 0;
}

//------------------------------------------------------------------------------
int vtkMedialRanks::size() const
{
  return this->Controller ? this->Controller->GetNumberOfProcesses() : 1;
}

//------------------------------------------------------------------------------
std::vector<Message> vtkMedialRanks::exchange(std::vector<Message> messages)
{
  return vtkExchangeInPairs(
    this->rank(), std::move(messages),
    [this](const Message& message, int to) { this->Send(message, to); },
    [this](int from) { return this->Receive(from); });
}

//------------------------------------------------------------------------------
// A message goes in parts: the length and what fits beside it, then the rest. Most are short.
void vtkMedialRanks::Send(const Message& message, int to)
{
  const std::uint64_t length = message.size();
  std::size_t sent = std::min(message.size(), FirstPart);
  Message first(sizeof(length) + sent);
  std::memcpy(first.data(), &length, sizeof(length));
  std::copy_n(message.begin(), sent, first.begin() + sizeof(length));
  this->Controller->Send(first.data(), static_cast<vtkIdType>(first.size()), to, MessageTag);
  while (sent < message.size())
  {
    const std::size_t part = std::min(LargestPart, message.size() - sent);
    this->Controller->Send(message.data() + sent, static_cast<vtkIdType>(part), to, MessageTag);
    sent += part;
  }
}

//------------------------------------------------------------------------------
Message vtkMedialRanks::Receive(int from)
{
  std::uint64_t length = 0;
  Message first(sizeof(length) + FirstPart);
  this->Controller->Receive(first.data(), static_cast<vtkIdType>(first.size()), from, MessageTag);
  std::memcpy(&length, first.data(), sizeof(length));
  Message message(length);
  std::size_t received = std::min(message.size(), FirstPart);
  std::copy_n(first.begin() + sizeof(length), received, message.begin());
  while (received < message.size())
  {
    const std::size_t part = std::min(LargestPart, message.size() - received);
    this->Controller->Receive(message.data() + received, static_cast<vtkIdType>(part), from,
      MessageTag);
    received += part;
  }
  return message;
}

//------------------------------------------------------------------------------
std::vector<vtkPieceFacts> vtkMedialRanks::Meet(Stage stage, const std::string& options,
  const std::function<vtkPieceFacts()>& work)
{
  const Message own = Try(stage, options, work).ToMessage();
  const auto ranks = static_cast<std::size_t>(this->size());
  std::vector<FullReport> reports;
  const auto askedForInformation = [](const FullReport& report)
  { return report.Stage == Stage::Information; };
  do
  {
    reports.clear();
    for (const Message& message : this->exchange(std::vector<Message>(ranks, own)))
    {
      reports.push_back(FullReport::Of(message));
    }
    for (std::size_t rank = 0; rank < ranks; ++rank)
    {
      if (reports[rank].Failed)
      {
        ThrowOf(rank, ranks, reports[rank].Code, reports[rank].Text);
      }
    }
    RequireSameOptions(reports);
  } while (
    stage == Stage::Data && std::any_of(reports.begin(), reports.end(), askedForInformation));
  std::vector<vtkPieceFacts> facts;
  for (const FullReport& report : reports)
  {
    facts.push_back(report.Facts);
  }
  return facts;
}

//------------------------------------------------------------------------------
medial::Bounds vtkMedialRanks::BoundsOf(const std::vector<vtkPieceFacts>& pieces)
{
  constexpr double far = std::numeric_limits<double>::infinity();
  medial::Bounds bounds{ { far, far, far }, { -far, -far, -far } };
  bool empty = true;
  for (const vtkPieceFacts& piece : pieces)
  {
    empty = empty && piece.Empty;
    for (int axis = 0; axis < 3 && !piece.Empty; ++axis)
    {
      bounds.min[axis] = std::min(bounds.min[axis], piece.Bounds.min[axis]);
      bounds.max[axis] = std::max(bounds.max[axis], piece.Bounds.max[axis]);
    }
  }
  if (empty)
  {
    throw medial::Error(medial::ErrorCode::InvalidInput, "the mesh has no cells");
  }
  return bounds;
}
