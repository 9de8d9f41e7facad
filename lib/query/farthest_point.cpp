#include "query/farthest_point.h"

#include "base/range_check.h"
#include "medial/error.h"
#include "mesh/cell_check.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace medial
{
namespace
{

/// The bound need not be nearer to the distance than this share of the diagonal.
constexpr double kNegligible = 1e-6;
constexpr int kMaxSteps = 1000000;
constexpr std::size_t kTogether = 256;

/// A position of the surface and what is nearest to it, local coordinates.
struct Corner
{
  glm::dvec3 x;
  SitePoint closest;

  double distance() const { return glm::distance(x, closest.point); }
};

/// A piece of the surface: a triangle, or a segment or a point whose corners repeat.
struct Piece
{
  std::array<Corner, 3> corners;
  double bound; ///< no point of it is farther from the mesh

  bool operator<(const Piece& other) const { return bound < other.bound; }
};

Corner cornerAt(DistanceQuery::Search& search, const glm::dvec3& x)
{
  return { x, search.closest(x) };
}

/// Returns the largest distance of a piece's corners from a site. Since that distance is convex, no
/// point of the piece is farther from the site, or from the mesh.
double distanceFrom(const SiteSet& sites, int site, const std::array<Corner, 3>& corners)
{
  double largest = 0.0;
  for (const Corner& corner : corners)
  {
    largest = std::max(largest, glm::distance(corner.x, closestPoint(sites, site, corner.x).point));
  }
  return largest;
}

/// Returns a bound of the distances in a piece: from the closest site of each corner, or the
/// corner's own distance and the way from there.
double boundOf(const SiteSet& sites, const std::array<Corner, 3>& corners)
{
  double bound = std::numeric_limits<double>::infinity();
  for (const Corner& from : corners)
  {
    double way = 0.0;
    for (const Corner& to : corners)
    {
      way = std::max(way, glm::distance(from.x, to.x));
    }
    bound =
      std::min({ bound, distanceFrom(sites, from.closest.site, corners), from.distance() + way });
  }
  return bound;
}

class FarthestSearch
{
public:
  FarthestSearch(const DistanceQuery& query, const TriangleMesh& surface, double tolerance)
    : query_(query)
    , search_(query)
    , tolerance_(tolerance)
    , negligible_(kNegligible * surface.bounds().diagonal() / query.local().unit)
  {
    this->addPieces(surface);
  }

  FarthestPoint run(const Checkpoint& checkpoint)
  {
    std::make_heap(pieces_.begin(), pieces_.end());
    for (int step = 0; step<kMaxSteps&& this->bound()> this->enough(); ++step)
    {
      checkpoint(static_cast<std::size_t>(step));
      std::pop_heap(pieces_.begin(), pieces_.end());
      const Piece piece = pieces_.back();
      pieces_.pop_back();
      this->halve(piece);
    }
    const LocalCoordinates& local = query_.local();
    return { local.toWorld(farthest_.x), farthest_.distance() * local.unit,
      this->bound() * local.unit };
  }

private:
  void addPieces(const TriangleMesh& surface)
  {
    const std::vector<Corner> corners = this->cornersOf(surface);
    std::vector<glm::ivec3> cells;
    for (const auto& [a, b, c] : surface.triangles)
    {
      cells.emplace_back(a, b, c);
    }
    for (const auto& [a, b] : surface.segments)
    {
      cells.emplace_back(a, b, b);
    }
    farthest_ = *std::max_element(corners.begin(), corners.end(),
      [](const Corner& a, const Corner& b) { return a.distance() < b.distance(); });
    std::vector<Piece> pieces(cells.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells.size(), kTogether),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        DistanceQuery::Search search(query_);
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          const glm::ivec3& cell = cells[i];
          pieces[i] = this->pieceOf({ corners[cell.x], corners[cell.y], corners[cell.z] }, search);
        }
      });
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(pieces_),
      [&](const Piece& piece) { return piece.bound > this->enough(); });
  }

  Piece pieceOf(const std::array<Corner, 3>& corners, DistanceQuery::Search& search) const
  {
    double bound = boundOf(query_.sites(), corners);
    if (bound > this->enough())
    {
      const SitePoint& closest = search.closest((corners[0].x + corners[1].x + corners[2].x) / 3.0);
      bound = std::min(bound, distanceFrom(query_.sites(), closest.site, corners));
    }
    return { corners, bound };
  }

  std::vector<Corner> cornersOf(const TriangleMesh& surface) const
  {
    std::vector<Corner> corners(surface.points.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, corners.size(), kTogether),
      [&](const tbb::blocked_range<std::size_t>& range)
      {
        DistanceQuery::Search search(query_);
        for (std::size_t i = range.begin(); i != range.end(); ++i)
        {
          requireUsable(i, surface.points[i]);
          corners[i] = cornerAt(search, query_.local().toLocal(surface.points[i]));
        }
      });
    return corners;
  }

  /// Cuts a piece in the middle of its longest edge.
  void halve(const Piece& piece)
  {
    const auto& corners = piece.corners;
    const auto length = [&](int i) { return glm::distance(corners[i].x, corners[(i + 1) % 3].x); };
    int longest = 0;
    for (int i = 1; i < 3; ++i)
    {
      longest = length(i) > length(longest) ? i : longest;
    }
    const Corner& from = corners[longest];
    const Corner& to = corners[(longest + 1) % 3];
    const Corner& opposite = corners[(longest + 2) % 3];
    const Corner middle = cornerAt(search_, 0.5 * (from.x + to.x));
    if (middle.distance() > farthest_.distance())
    {
      farthest_ = middle;
    }
    // Of a segment one end stands for two corners.
    const Corner& beforeMiddle = opposite.x == to.x ? middle : opposite;
    const Corner& afterMiddle = opposite.x == from.x ? middle : opposite;
    this->add(this->pieceOf({ from, middle, beforeMiddle }, search_), piece.bound);
    this->add(this->pieceOf({ middle, to, afterMiddle }, search_), piece.bound);
  }

  void add(Piece piece, double bound)
  {
    piece.bound = std::min(piece.bound, bound);
    if (piece.bound > this->enough())
    {
      pieces_.push_back(piece);
      std::push_heap(pieces_.begin(), pieces_.end());
    }
  }

  /// Bounds up to this need no more search.
  double enough() const
  {
    const double distance = farthest_.distance();
    return distance + std::max(tolerance_ * distance, negligible_);
  }

  double bound() const
  {
    return pieces_.empty() ? this->enough() : std::max(this->enough(), pieces_.front().bound);
  }

  const DistanceQuery& query_;
  DistanceQuery::Search search_;
  double tolerance_;
  double negligible_; ///< local units
  Corner farthest_{};
  std::vector<Piece> pieces_; ///< a heap of those with bounds that are not good enough
};

} // namespace

void checkTolerance(double tolerance)
{
  if (!(tolerance > 0.0 && tolerance < 1.0))
  {
    throwOutside("tolerance", tolerance, "(0, 1)");
  }
}

FarthestPoint farthestPoint(const DistanceQuery& query, const TriangleMesh& surface,
  double tolerance, const Checkpoint& checkpoint)
{
  requireCells(surface);
  return FarthestSearch(query, surface, tolerance).run(checkpoint);
}

} // namespace medial
