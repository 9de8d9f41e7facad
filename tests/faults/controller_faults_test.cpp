#include "failing_allocations.h"

#include "lib/ranks/pieces.h"
#include "medial/error.h"
#include "medial/ranks.h"
#include "support/shapes.h"

#include <vtkCellArray.h>
#include <vtkCommunicator.h>
#include <vtkDummyController.h>
#include <vtkMedialRanks.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSurfacePiece.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <mutex>
#include <new>
#include <set>
#include <string>
#include <thread>
#include <vector>

// Ranks that talk through a controller of VTK, where one of them has no memory: none waits for
// ever.

namespace medial::test
{
namespace
{

constexpr int kRanks = 3;

/// Carries bytes from one thread to another, and takes no memory for it.
class Line
{
public:
  void send(const void* data, std::size_t bytes)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    data_ = data;
    bytes_ = bytes;
    changed_.notify_all();
    changed_.wait(lock, [this] { return data_ == nullptr; });
  }

  void receive(void* data, std::size_t room)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return data_ != nullptr; });
    EXPECT_LE(bytes_, room);
    std::memcpy(data, data_, std::min(bytes_, room));
    data_ = nullptr;
    changed_.notify_all();
  }

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  const void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

using Lines = std::array<std::array<Line, kRanks>, kRanks>; ///< from, to

class ThreadCommunicator : public vtkCommunicator
{
public:
  static ThreadCommunicator* New();
  vtkTypeMacro(ThreadCommunicator, vtkCommunicator)

    void use(Lines& lines, int rank)
  {
    this->MaximumNumberOfProcesses = kRanks;
    this->NumberOfProcesses = kRanks;
    this->LocalProcessId = rank;
    lines_ = &lines;
  }

  int SendVoidArray(const void* data, vtkIdType length, int type, int to, int /*tag*/) override
  {
    EXPECT_EQ(type, VTK_CHAR);
    (*lines_)[this->LocalProcessId][to].send(data, static_cast<std::size_t>(length));
    return 1;
  }

  int ReceiveVoidArray(void* data, vtkIdType length, int type, int from, int /*tag*/) override
  {
    EXPECT_EQ(type, VTK_CHAR);
    (*lines_)[from][this->LocalProcessId].receive(data, static_cast<std::size_t>(length));
    return 1;
  }

private:
  Lines* lines_ = nullptr;
};

vtkStandardNewMacro(ThreadCommunicator);

/// Runs work on every rank. From then on allocations count, on whatever rank.
/// @param failing the one that fails; none for 0.
/// @return how many there were.
std::int64_t run(std::int64_t failing, const std::function<void(vtkMedialRanks& ranks)>& work)
{
  Lines lines;
  std::once_flag started;
  std::vector<std::thread> threads;
  for (int rank = 0; rank < kRanks; ++rank)
  {
    threads.emplace_back(
      [&, rank]
      {
        vtkNew<ThreadCommunicator> communicator;
        communicator->use(lines, rank);
        vtkNew<vtkDummyController> controller;
        controller->SetCommunicator(communicator);
        vtkMedialRanks ranks(controller);
        // All threads are there then: starting one takes memory.
        ranks.exchange(std::vector<Communicator::Message>(kRanks));
        std::call_once(started, [&] { failAllocation(failing, Failing::Once); });
        work(ranks);
      });
  }
  std::for_each(threads.begin(), threads.end(), [](std::thread& thread) { thread.join(); });
  return stopFailing();
}

/// What one of the ranks does, within agree().
using Work = std::function<void(vtkMedialRanks& ranks)>;

/// Returns how each rank ends: by what error, or none.
std::vector<std::string> endings(std::int64_t failing, const Work& work, std::int64_t* count)
{
  std::vector<std::string> errors(kRanks);
  const std::int64_t allocations = run(failing,
    [&](vtkMedialRanks& ranks)
    {
      std::string& error = errors[ranks.rank()];
      try
      {
        agree(ranks, [&] { work(ranks); });
      }
      catch (const Error& caught)
      {
        EXPECT_EQ(caught.code(), ErrorCode::OutOfMemory) << caught.what();
        error = caught.what();
      }
      catch (const std::bad_alloc&)
      {
        error = "only this rank knows of it";
      }
    });
  if (count != nullptr)
  {
    *count = allocations;
  }
  return errors;
}

/// Lets allocations fail, on any rank, and expects all ranks to end alike.
void expectFailuresToBeKnown(const Work& work)
{
  std::int64_t count = 0;
  ASSERT_EQ(endings(0, work, &count), std::vector<std::string>(kRanks));
  std::set<char> failed; // ranks
  for (std::int64_t n = 1; n <= count; n += stepBetweenFailures(count))
  {
    SCOPED_TRACE("allocation " + std::to_string(n) + " of " + std::to_string(count));
    const std::vector<std::string> errors = endings(n, work, nullptr);
    ASSERT_EQ(errors, std::vector<std::string>(kRanks, errors.front()));
    if (!errors.front().empty()) // otherwise there was another way
    {
      EXPECT_EQ(errors.front().rfind("rank ", 0), 0U) << errors.front();
      failed.insert(errors.front()[5]);
    }
  }
  EXPECT_EQ(failed, (std::set<char>{ '0', '1', '2' }));
}

/// A message that goes in several parts, and says where it is from.
Communicator::Message longMessage(int from)
{
  return Communicator::Message(300000 + 1000 * from, static_cast<char>(from));
}

TEST(ControllerFaults, WhereMessagesComeInAreKnownToAll)
{
  expectFailuresToBeKnown(
    [](vtkMedialRanks& ranks)
    {
      for (int time = 0; time < 2; ++time)
      {
        const std::vector<Communicator::Message> received =
          gathered(ranks, longMessage(ranks.rank()));
        for (int from = 0; from < kRanks; ++from)
        {
          EXPECT_EQ(received[from], longMessage(from));
        }
      }
    });
}

vtkSurfacePiece pieceOf(const TriangleMesh& mesh, int rank)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& point : mesh.points)
  {
    points->InsertNextPoint(point.data());
  }
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    if (atRandom(kRanks)(i) == rank || i % 7 == 0) // copies
    {
      const auto& [a, b, c] = mesh.triangles[i];
      cells->InsertNextCell({ a, b, c });
    }
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  return vtkSurfacePiece(data);
}

TEST(ControllerFaults, WhereRanksNumberTheirPiecesAreKnownToAll)
{
  const TriangleMesh mesh = numbered(icosphere(1.0, 1));
  std::vector<vtkSurfacePiece> pieces;
  for (int rank = 0; rank < kRanks; ++rank)
  {
    pieces.push_back(pieceOf(mesh, rank));
  }
  std::array<std::size_t, kRanks> triangles{};
  expectFailuresToBeKnown(
    [&](vtkMedialRanks& ranks)
    {
      vtkSurfacePiece piece = pieces[ranks.rank()];
      const std::vector<vtkPieceFacts> facts =
        ranks.Meet(vtkMedialRanks::Stage::Data, "Resolution 20\n", [&] { return piece.Facts(); });
      triangles[ranks.rank()] = piece.Numbered(ranks, facts).mesh.triangles.size();
    });
  EXPECT_EQ(triangles[0] + triangles[1] + triangles[2], mesh.triangles.size());
}

} // namespace
} // namespace medial::test
