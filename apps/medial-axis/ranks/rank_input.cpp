#include "ranks/rank_input.h"

#include "failure.h"
#include "input/input_file.h"
#include "input/surface_reader.h"
#include "library_calls.h"
#include "list_message.h"
#include "ranks/mesh_pieces.h"
#include "ranks/rank_agreement.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace medial::app
{
namespace
{

using Message = Communicator::Message;

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

/// Calls visit(list) with each list of a piece, in the order in which messages have them.
template <typename Piece, typename Visitor>
void visitLists(Piece& piece, const Visitor& visit)
{
  visit(piece.mesh.points);
  visit(piece.pointOrder);
  visit(piece.mesh.triangles);
  visit(piece.mesh.triangleCells);
  visit(piece.mesh.segments);
  visit(piece.mesh.segmentCells);
  visit(piece.mesh.vertices);
  visit(piece.mesh.vertexCells);
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
    ListMessage message;
    message.putOne(bounds);
    visitLists(piece, [&](const auto& list) { message.put(list); });
    messages.push_back(std::move(message.bytes));
    begin = end;
  }
  return messages;
}

MeshFigures figuresOf(const SurfaceFigures& surface)
{
  MeshFigures figures;
  figures.triangles = static_cast<std::size_t>(surface.triangles);
  figures.points = static_cast<std::size_t>(surface.points);
  figures.components = surface.components;
  figures.degenerateTriangles = surface.degenerateTriangles;
  figures.closed = surface.closed;
  figures.manifold = surface.manifold;
  return figures;
}

/// Takes a piece out of a message.
SurfacePiece receivedPiece(Message bytes, Bounds& bounds)
{
  ListMessage message(std::move(bytes));
  SurfacePiece piece;
  message.takeOne(bounds);
  visitLists(piece, [&](auto& list) { message.take(list); });
  return piece;
}

} // namespace

Share readShare(const Options& options, bool keepsWhole, Communicator& communicator)
{
  Share share;
  if (isInPieces(options.input))
  {
    MeshPiece own = readMeshPiece(options.input, communicator);
    share.piece = std::move(own.piece);
    share.bounds = own.bounds;
    if (!options.report.empty())
    {
      withFailures(options.input,
        [&] { share.figures = figuresOf(measureSurface(communicator, share.piece)); });
    }
    share.figures.diagonal = share.bounds.diagonal();
    return share;
  }
  std::vector<Message> messages(static_cast<std::size_t>(communicator.size()));
  withFailuresOfFirst(communicator,
    [&]
    {
      withFailures(options.input,
        [&]
        {
          Surface surface = readSurface(options.input);
          TriangleMesh mesh = surface.toTriangleMesh();
          messages = sharesOf(mesh, messages.size());
          if (!options.report.empty())
          {
            share.figures =
              figuresOf(mesh, analyseConnectivity(mesh, { options.threads, nullptr }));
          }
          if (keepsWhole)
          {
            share.whole = std::move(mesh);
          }
          if (extensionOf(options.thickness) == ".vtp")
          {
            share.surface = std::move(surface);
          }
        });
    });
  share.piece =
    receivedPiece(std::move(communicator.exchange(std::move(messages)).front()), share.bounds);
  share.figures.diagonal = share.bounds.diagonal();
  return share;
}

} // namespace medial::app
