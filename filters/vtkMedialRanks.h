/**
 * The processes of a controller as ranks of the library, and where they meet. Not installed:
 * private to the module and to the project's programs.
 */

#ifndef vtkMedialRanks_h
#define vtkMedialRanks_h

#include "medial/grid.h"
#include "medial/ranks.h"

#include <cstdint>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkMultiProcessController;

/**
 * What a rank tells the others of its piece of a surface.
 */
struct vtkPieceFacts
{
  medial::Bounds Bounds{}; // of the points of cells; meaningless where Empty
  bool Empty = true;
  bool CellIds = false;             // whether cells have global ids
  bool PointIds = false;            // whether points have global ids
  std::int64_t TrianglesOfCell = 0; // most triangles of a cell
  std::int64_t LargestCell = -1;    // largest number of a cell
};

/**
 * Passes messages[r] on to rank r, and returns what each rank passed on to this one: in each round
 * every rank talks to one other, and the lower one sends first, so that none waits for one that
 * waits for it. send(message, to) and receive(from) talk to a rank. Where receive throws, it must
 * have taken all of the message from there; what it throws comes once all ranks have what they
 * wait for.
 */
template <typename Send, typename Receive>
std::vector<medial::Communicator::Message> vtkExchangeInPairs(int own,
  std::vector<medial::Communicator::Message> messages, const Send& send, const Receive& receive)
{
  const auto ranks = static_cast<int>(messages.size());
  std::vector<medial::Communicator::Message> received(messages.size());
  std::exception_ptr failure;
  const auto tryToReceive = [&](int from)
  {
    try
    {
      received[from] = receive(from);
    }
    catch (const std::exception&)
    {
      failure = std::current_exception();
    }
  };
  for (int round = 0; round < ranks; ++round)
  {
    const int other = (round - own + ranks) % ranks;
    if (other == own)
    {
      received[own] = std::move(messages[own]);
    }
    else if (own < other)
    {
      send(messages[other], other);
      tryToReceive(other);
    }
    else
    {
      tryToReceive(other);
      send(messages[other], other);
    }
    medial::Communicator::Message().swap(messages[other]);
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return received;
}

class vtkMedialRanks : public medial::Communicator
{
public:
  /**
   * controller may be null: a single rank. It must outlive this.
   */
  explicit vtkMedialRanks(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  int rank() const override;
  int size() const override;
  std::vector<Message> exchange(std::vector<Message> messages) override;

  /**
   * What ranks meet for.
   */
  enum class Stage : char
  {
    Information,
    Data
  };

  /**
   * Does work that may fail on some ranks only, and tells the others how it went. Every rank calls
   * it. Pipelines may ask one rank more often for information than another: who is here for Data
   * answers those until all are. Returns what the work of each rank returned.
   *
   * options has lines of a name and values that must be the same everywhere. Throws medial::Error
   * on every rank, as medial::agree(), if any has failed or has other options.
   */
  std::vector<vtkPieceFacts> Meet(Stage stage, const std::string& options,
    const std::function<vtkPieceFacts()>& work);

  /**
   * The bounds of all pieces. Throws medial::Error if they are all empty.
   */
  static medial::Bounds BoundsOf(const std::vector<vtkPieceFacts>& pieces);

private:
  void Send(const Message& message, int to);
  Message Receive(int from);

  vtkMultiProcessController* Controller;
};

#endif
