#include "rank_input.h"

#include "failure.h"
#include "library_calls.h"
#include "rank_agreement.h"
#include "surface_reader.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

/// The lists of a piece, one after the other.
class PieceMessage
{
public:
  template <typename T>
  void put(const std::vector<T>& list)
  {
    const std::uint64_t count = list.size();
    this->append(&count, sizeof(count));
    this->append(list.data(), count * sizeof(T));
  }

  template <typename T>
  void take(std::vector<T>& list)
  {
    std::uint64_t count = 0;
    this->extract(&count, sizeof(count));
    list.resize(count);
    this->extract(list.data(), count * sizeof(T));
  }

  template <typename T>
  void putOne(const T& value)
  {
    this->append(&value, sizeof(value));
  }

  template <typename T>
  void takeOne(T& value)
  {
    this->extract(&value, sizeof(value));
  }

  Message bytes;

private:
  void append(const void* from, std::size_t count)
  {
    const auto* const first = static_cast<const char*>(from);
    bytes.insert(bytes.end(), first, first + count);
  }
  void extract(void* to, std::size_t count)
  {
    if (count > 0)
    {
      std::memcpy(to, bytes.data() + next_, count);
    }
    next_ += count;
  }

  std::size_t next_ = 0;
};

/// Takes triangles [begin, end) out of a mesh.
SurfacePiece pieceOf(const TriangleMesh& mesh, std::size_t begin, std::size_t end)
{
  SurfacePiece piece;
  std::map<int, int> localOf;
  const auto local = [&](int point)
  {
    const auto [found, isNew] =
      localOf.insert({ point, static_cast<int>(piece.mesh.points.size()) });
    if (isNew)
    {
      piece.mesh.points.push_back(mesh.points[point]);
      piece.pointOrder.push_back(point);
    }
    return found->second;
  };
  for (std::size_t i = begin; i < end; ++i)
  {
    std::array<int, 3> corners{};
    std::transform(mesh.triangles[i].begin(), mesh.triangles[i].end(), corners.begin(), local);
    piece.mesh.triangles.push_back(corners);
    piece.mesh.triangleCells.push_back(mesh.triangleCells[i]);
  }
  if (begin == 0)
  {
    for (const auto& [a, b] : mesh.segments)
    {
      const int first = local(a);
      piece.mesh.segments.push_back({ first, local(b) });
    }
    std::transform(mesh.vertices.begin(), mesh.vertices.end(),
      std::back_inserter(piece.mesh.vertices), local);
    piece.mesh.segmentCells = mesh.segmentCells;
    piece.mesh.vertexCells = mesh.vertexCells;
  }
  return piece;
}

/// Cuts a mesh into messages for all ranks.
std::vector<Message> sharesOf(const TriangleMesh& mesh, std::size_t ranks)
{
  const std::size_t triangles = mesh.triangles.size();
  if (!std::is_sorted(mesh.triangleCells.begin(), mesh.triangleCells.end()))
  {
    throw Failure(ExitCode::BadInput, "its triangles are not in the order of cells");
  }
  const Bounds bounds = mesh.bounds();
  std::vector<Message> messages;
  std::size_t begin = 0;
  for (std::size_t rank = 1; rank <= ranks; ++rank)
  {
    std::size_t end = std::max(begin, triangles * rank / ranks);
    // The triangles of a cell stay together.
    while (end > begin && end < triangles && mesh.triangleCells[end] == mesh.triangleCells[end - 1])
    {
      ++end;
    }
    const SurfacePiece piece = pieceOf(mesh, begin, end);
    PieceMessage message;
    message.putOne(bounds);
    message.put(piece.mesh.points);
    message.put(piece.pointOrder);
    message.put(piece.mesh.triangles);
    message.put(piece.mesh.triangleCells);
    message.put(piece.mesh.segments);
    message.put(piece.mesh.segmentCells);
    message.put(piece.mesh.vertices);
    message.put(piece.mesh.vertexCells);
    messages.push_back(std::move(message.bytes));
    begin = end;
  }
  return messages;
}

} // namespace

Share readShare(const Options& options, bool keepsWhole, Communicator& communicator)
{
  std::vector<Message> messages(static_cast<std::size_t>(communicator.size()));
  Share share;
  agree(communicator,
    [&]
    {
      if (communicator.rank() == 0)
      {
        withFailures(options.input,
          [&]
          {
            TriangleMesh mesh = readSurface(options.input).toTriangleMesh();
            messages = sharesOf(mesh, messages.size());
            if (keepsWhole)
            {
              share.whole = std::move(mesh);
            }
          });
      }
    });
  PieceMessage message;
  message.bytes = std::move(communicator.exchange(std::move(messages)).front());
  message.takeOne(share.bounds);
  message.take(share.piece.mesh.points);
  message.take(share.piece.pointOrder);
  message.take(share.piece.mesh.triangles);
  message.take(share.piece.mesh.triangleCells);
  message.take(share.piece.mesh.segments);
  message.take(share.piece.mesh.segmentCells);
  message.take(share.piece.mesh.vertices);
  message.take(share.piece.mesh.vertexCells);
  return share;
}

} // namespace medial::app
