#include "base/run.h"
#include "measure/reconstruction_field.h"
#include "medial/error.h"
#include "medial/memory.h"
#include "medial/ranks.h"
#include "medial/reconstruction.h"
#include "ranks/collective.h"
#include "ranks/reconstruction/near_primitives.h"

#include <numeric>
#include <utility>

namespace medial
{
namespace
{

/// Whether a piece has nothing, which a whole model must not.
bool isEmpty(const MedialModel& piece)
{
  return piece.centres.empty() && piece.radii.empty() && piece.quads.empty() &&
    piece.triangles.empty() && piece.lines.empty() && piece.vertices.empty();
}

/// @throws Error as checkMedialModel(), if no rank has a ball.
void requireBalls(Communicator& communicator, const MedialModel& piece)
{
  const auto balls = static_cast<std::int64_t>(piece.centres.size());
  const std::vector<std::int64_t> all = gathered(communicator, balls);
  if (std::accumulate(all.begin(), all.end(), std::int64_t{ 0 }) == 0)
  {
    checkMedialModel({});
  }
}

} // namespace

Bounds modelBounds(Communicator& communicator, const MedialModel& piece)
{
  Bounds bounds = kEmptyBounds;
  agree(communicator,
    [&]
    {
      const Bounds own = isEmpty(piece) ? kEmptyBounds : modelBounds(piece);
      requireBalls(communicator, piece);
      for (const Bounds& part : gathered(communicator, own))
      {
        bounds = joined(bounds, part);
      }
    });
  return bounds;
}

std::vector<float> computeReconstruction(Communicator& communicator, const MedialModel& piece,
  const Grid& grid, const Extent& extent, const ReconstructionOptions& options)
{
  std::vector<float> field;
  agree(communicator,
    [&]
    {
      const Run run(options.execution);
      validateGrid(grid);
      if (!extent.empty() && !grid.wholeExtent().contains(extent))
      {
        throw Error(ErrorCode::InvalidInput, "the extent leaves the grid");
      }
      requireMemory(extent.pointCount(), sizeof(float));
      BallPrimitives parts =
        isEmpty(piece) ? BallPrimitives{} : primitivesOf(piece, options.interpolate);
      requireBalls(communicator, piece);
      parts = nearPrimitives(communicator, parts, grid, extent);
      field = reconstructionField(BallUnion(std::move(parts)), grid, extent, run);
    });
  return field;
}

} // namespace medial
