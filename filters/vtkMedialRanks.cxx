#include "vtkMedialRanks.h"

#include "vtkMultiProcessController.h"

#include "medial/error.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <exception>
#include <iterator>
#include <sstream>
#include <utility>

namespace
{

constexpr int MessageTag = 18064;
// Messages go in parts that are read into the stack where there is no memory for them.
constexpr std::size_t LargestPart = std::size_t{ 1 } << 16;
constexpr std::size_t FirstPart = 4096;

using Message = medial::Communicator::Message;

//------------------------------------------------------------------------------
// A message begins with its length and what fits beside it.
struct FirstMessage
{
  std::uint64_t Length;
  std::array<char, FirstPart> Content;
};

constexpr std::size_t HeadSize = offsetof(FirstMessage, Content);

//------------------------------------------------------------------------------
// What a rank says where ranks meet: this, then its options.
struct Report
{
  vtkMedialRanks::Stage Stage;
  vtkPieceFacts Facts;
};

//------------------------------------------------------------------------------
struct FullReport : Report
{
  std::string Options;

  Message ToMessage() const
  {
    const Report& head = *this;
    Message message(sizeof(head));
    std::memcpy(message.data(), &head, sizeof(head));
    message.insert(message.end(), this->Options.begin(), this->Options.end());
    return message;
  }

  static FullReport Of(const Message& message)
  {
    FullReport report;
    Report& head = report;
    std::memcpy(static_cast<void*>(&head), message.data(), sizeof(head));
    report.Options.assign(message.begin() + sizeof(head), message.end());
    return report;
  }
};

//------------------------------------------------------------------------------
// Where lines differ; those that only one has do not count, as ranks may be at different stages.
void RequireSameOptions(const std::vector<FullReport>& reports)
{
  for (std::size_t rank = 1; rank < reports.size(); ++rank)
  {
    std::istringstream expected(reports.front().Options);
    std::istringstream found(reports[rank].Options);
    std::string theirs;
    std::string here;
    while (std::getline(expected, theirs) && std::getline(found, here))
    {
      if (here != theirs)
      {
        std::string message = "rank " + std::to_string(rank) + ": ";
        message.append(here).append(", but rank 0 has ").append(theirs);
        throw medial::Error(medial::ErrorCode::InvalidInput, message);
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
// Takes no memory: the other rank waits for all of the message. Most messages are short.
void vtkMedialRanks::Send(const Message& message, int to)
{
  FirstMessage first;
  first.Length = message.size();
  std::size_t sent = std::min(message.size(), FirstPart);
  std::copy_n(message.begin(), sent, first.Content.begin());
  this->Controller->Send(reinterpret_cast<const char*>(&first),
    static_cast<vtkIdType>(HeadSize + sent), to, MessageTag);
  while (sent < message.size())
  {
    const std::size_t part = std::min(LargestPart, message.size() - sent);
    this->Controller->Send(message.data() + sent, static_cast<vtkIdType>(part), to, MessageTag);
    sent += part;
  }
}

//------------------------------------------------------------------------------
// Without memory for the message it still takes all of it from the other rank.
Message vtkMedialRanks::Receive(int from)
{
  FirstMessage first;
  this->Controller->Receive(reinterpret_cast<char*>(&first),
    static_cast<vtkIdType>(HeadSize + FirstPart), from, MessageTag);
  const auto length = static_cast<std::size_t>(first.Length);
  Message message;
  std::exception_ptr failure;
  try
  {
    message.resize(length);
  }
  catch (const std::exception&)
  {
    failure = std::current_exception();
  }
  std::size_t received = std::min(length, FirstPart);
  std::copy_n(first.Content.begin(), failure ? 0 : received, message.begin());
  std::array<char, LargestPart> unwanted;
  while (received < length)
  {
    const std::size_t part = std::min(LargestPart, length - received);
    this->Controller->Receive(failure ? unwanted.data() : message.data() + received,
      static_cast<vtkIdType>(part), from, MessageTag);
    received += part;
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return message;
}

//------------------------------------------------------------------------------
std::vector<vtkPieceFacts> vtkMedialRanks::Meet(Stage stage, const std::string& options,
  const std::function<vtkPieceFacts()>& work)
{
  std::vector<FullReport> reports;
  Message own;
  const auto meet = [&]
  {
    if (own.empty())
    {
      own = FullReport{ { stage, work() }, options }.ToMessage();
    }
    reports.clear();
    for (const Message& message : medial::gathered(*this, own))
    {
      reports.push_back(FullReport::Of(message));
    }
    RequireSameOptions(reports);
  };
  const auto askedForInformation = [](const FullReport& report)
  { return report.Stage == Stage::Information; };
  do
  {
    medial::agree(*this, meet);
  } while (
    stage == Stage::Data && std::any_of(reports.begin(), reports.end(), askedForInformation));
  std::vector<vtkPieceFacts> facts;
  std::transform(reports.begin(), reports.end(), std::back_inserter(facts),
    [](const FullReport& report) { return report.Facts; });
  return facts;
}

//------------------------------------------------------------------------------
medial::Bounds vtkMedialRanks::BoundsOf(const std::vector<vtkPieceFacts>& pieces)
{
  medial::Bounds bounds = medial::kEmptyBounds;
  for (const vtkPieceFacts& piece : pieces)
  {
    bounds = piece.Empty ? bounds : medial::joined(bounds, piece.Bounds);
  }
  if (bounds.empty())
  {
    throw medial::Error(medial::ErrorCode::InvalidInput, "the mesh has no cells");
  }
  return bounds;
}
