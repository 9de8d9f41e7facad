#include "skeleton/sheet_fire.h"

#include "base/huge_pages.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

namespace medial
{
namespace
{

/// The fire's way counts as straight while the sheet turns by less than this, 30 degrees.
constexpr double kStraightCosine = 0.866;

/// Where a fire comes from: it is `time` old there.
struct Source
{
  glm::dvec3 origin{ 0.0 };
  glm::dvec3 normal{ 0.0 }; ///< of the sheet there
  double time = 0.0;

  double arrival(const glm::dvec3& x) const { return time + glm::distance(x, origin); }
};

/// A polygon with three or four corners.
struct Face
{
  std::array<int, 4> edges{};
  int count = 0;
  bool burned = false;
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 normal{ 0.0 };
};

/// Small, since the fire jumps from edge to edge.
struct Edge
{
  static constexpr int kGone = -1; ///< burned together with a face

  std::array<int, 2> ends{};
  int firstFace = 0; ///< in the list of faces by edge
  int faces = 0;     ///< at first
  int left = 0;      ///< faces that have not burned
  int source = 0;    ///< of the fire in the face that has burned last, or kGone
  double time = 0.0; ///< when the last face has burned so far
};

/// An edge of a polygon.
struct FaceEdge
{
  std::array<int, 2> ends; ///< in ascending order
  int face;
  int corner;
};

/// Sorts edges of polygons by their ends, then by their faces.
void sortByEnds(std::vector<FaceEdge>& sides, std::size_t pointCount)
{
  std::vector<std::size_t> ends(pointCount + 1);
  for (const FaceEdge& side : sides)
  {
    ++ends[side.ends[0] + 1];
  }
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<FaceEdge> sorted = largeVector<FaceEdge>(sides.size());
  for (const FaceEdge& side : sides)
  {
    sorted[ends[side.ends[0]]++] = side;
  }
  const auto at = [&](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
  tbb::parallel_for(std::size_t{ 0 }, pointCount,
    [&](std::size_t point)
    {
      std::sort(at(point == 0 ? 0 : ends[point - 1]), at(ends[point]),
        [](const FaceEdge& a, const FaceEdge& b)
        { return std::tie(a.ends[1], a.face) < std::tie(b.ends[1], b.face); });
    });
  sides = std::move(sorted);
}

class SheetFire
{
public:
  SheetFire(const MedialAxis& axis, const std::vector<glm::dvec3>& positions,
    const std::vector<double>& radii, const Checkpoint& checkpoint)
    : positions_(positions)
    , radii_(radii)
    , checkpoint_(checkpoint)
  {
    result_.widths = radii;
    this->addFaces(axis);
    for (const auto& line : axis.lines)
    {
      result_.edges.push_back({ { std::min(line[0], line[1]), std::max(line[0], line[1]) },
        0.5 * (radii[line[0]] + radii[line[1]]) });
    }
  }

  BurnedSheets burn()
  {
    for (std::size_t e = 0; e < edges_.size(); ++e)
    {
      Edge& edge = edges_[e];
      if (edge.left == 1)
      {
        edge.source = this->addSource({ this->middle(edge), faces_[this->faceLeft(edge)].normal,
          0.5 * (radii_[edge.ends[0]] + radii_[edge.ends[1]]) });
        this->raise(static_cast<int>(e));
      }
    }
    do
    {
      this->drain();
    } while (this->open());
    for (const Edge& edge : edges_)
    {
      if (edge.source != Edge::kGone)
      {
        result_.edges.push_back({ { edge.ends[0], edge.ends[1] }, edge.time });
      }
    }
    tbb::parallel_sort(result_.edges.begin(), result_.edges.end(),
      [](const NetworkEdge& a, const NetworkEdge& b) { return a.ends < b.ends; });
    return std::move(result_);
  }

private:
  using Event = std::tuple<double, int, int>; ///< arrival, face, edge that it comes through

  void addFaces(const MedialAxis& axis)
  {
    const std::size_t quads = axis.quads.size();
    const std::size_t faces = quads + axis.triangles.size();
    const auto firstCorner = [quads](std::size_t f) { return 4 * f - (f > quads ? f - quads : 0); };
    resizeLarge(faces_, faces);
    resizeLarge(cornerOffsets_, faces + 1);
    resizeLarge(faceCorners_, firstCorner(faces));
    std::vector<FaceEdge> sides = largeVector<FaceEdge>(faceCorners_.size());
    tbb::parallel_for(std::size_t{ 0 }, faces,
      [&](std::size_t f)
      {
        cornerOffsets_[f + 1] = firstCorner(f + 1);
        if (f < quads)
        {
          this->setFace(f, axis.quads[f], firstCorner(f), sides);
        }
        else
        {
          this->setFace(f, axis.triangles[f - quads], firstCorner(f), sides);
        }
      });
    sortByEnds(sides, positions_.size());
    this->addEdges(sides);
  }

  /// @param first place of its corners and edges.
  template <typename Corners>
  void setFace(std::size_t f, const Corners& corners, std::size_t first,
    std::vector<FaceEdge>& sides)
  {
    Face& face = faces_[f];
    face.count = static_cast<int>(corners.size());
    glm::dvec3 area(0.0);
    for (int i = 0; i < face.count; ++i)
    {
      const auto a = static_cast<int>(corners[i]);
      const auto b = static_cast<int>(corners[(i + 1) % face.count]);
      faceCorners_[first + i] = a;
      sides[first + i] = { { std::min(a, b), std::max(a, b) }, static_cast<int>(f), i };
      face.centre += positions_[a] / static_cast<double>(face.count);
      area +=
        glm::cross(positions_[a] - positions_[corners[0]], positions_[b] - positions_[corners[0]]);
    }
    const double size = glm::length(area);
    face.normal = size > 0.0 ? area / size : area;
  }

  /// @param sides sorted by their ends.
  void addEdges(const std::vector<FaceEdge>& sides)
  {
    reserveLarge(facesOfEdges_, sides.size());
    reserveLarge(edges_, sides.size() / 2 + sides.size() / 8);
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      if (i == 0 || sides[i].ends != sides[i - 1].ends)
      {
        Edge edge;
        edge.ends = sides[i].ends;
        edge.firstFace = static_cast<int>(i);
        edges_.push_back(edge);
      }
      ++edges_.back().faces;
      ++edges_.back().left;
      facesOfEdges_.push_back(sides[i].face);
      faces_[sides[i].face].edges[sides[i].corner] = static_cast<int>(edges_.size()) - 1;
    }
  }

  glm::dvec3 middle(const Edge& edge) const
  {
    return 0.5 * (positions_[edge.ends[0]] + positions_[edge.ends[1]]);
  }

  int faceLeft(const Edge& edge) const
  {
    const auto begin = facesOfEdges_.begin() + edge.firstFace;
    return *std::find_if(begin, begin + edge.faces, [this](int f) { return !faces_[f].burned; });
  }

  /// Lets the fire into the only face that is left at an edge.
  void raise(int e)
  {
    const Edge& edge = edges_[e];
    const int face = this->faceLeft(edge);
    queue_.emplace(sources_[edge.source].arrival(faces_[face].centre), face, e);
  }

  void drain()
  {
    for (std::size_t events = 0; !queue_.empty(); ++events)
    {
      checkpoint_(events);
      const auto [time, face, edge] = queue_.top();
      queue_.pop();
      const int source = edges_[edge].source;
      if (!faces_[face].burned && source != Edge::kGone)
      {
        edges_[edge].source = Edge::kGone;
        this->burnFace(face, source);
      }
    }
  }

  int addSource(const Source& source)
  {
    sources_.push_back(source);
    return static_cast<int>(sources_.size()) - 1;
  }

  void burnFace(int f, int source)
  {
    Face& face = faces_[f];
    face.burned = true;
    const double time = sources_[source].arrival(face.centre);
    // On a curved sheet the fire's way is made of several straight lines.
    const bool straight =
      std::abs(glm::dot(sources_[source].normal, face.normal)) >= kStraightCosine;
    const int onward = straight ? source : this->addSource({ face.centre, face.normal, time });
    for (std::size_t c = cornerOffsets_[f]; c < cornerOffsets_[f + 1]; ++c)
    {
      double& width = result_.widths[faceCorners_[c]];
      width = std::max(width, time);
    }
    for (int i = 0; i < face.count; ++i)
    {
      Edge& edge = edges_[face.edges[i]];
      --edge.left;
      if (edge.source == Edge::kGone)
      {
        continue;
      }
      const glm::dvec3 x = this->middle(edge);
      edge.time = std::max(edge.time, sources_[onward].arrival(x));
      if (edge.left == 1)
      {
        edge.source = edge.faces == 2
          ? onward
          : this->addSource({ x, faces_[this->faceLeft(edge)].normal, edge.time });
        this->raise(face.edges[i]);
      }
    }
  }

  /// Burns the face of smallest radius if any is left. Returns whether there was one.
  bool open()
  {
    int best = -1;
    double bestRadius = 0.0;
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
      if (faces_[f].burned)
      {
        continue;
      }
      double radius = 0.0;
      for (std::size_t c = cornerOffsets_[f]; c < cornerOffsets_[f + 1]; ++c)
      {
        radius += radii_[faceCorners_[c]] / faces_[f].count;
      }
      if (best < 0 || radius < bestRadius)
      {
        best = static_cast<int>(f);
        bestRadius = radius;
      }
    }
    if (best >= 0)
    {
      ++result_.opened;
      this->burnFace(best,
        this->addSource({ faces_[best].centre, faces_[best].normal, bestRadius }));
    }
    return best >= 0;
  }

  const std::vector<glm::dvec3>& positions_;
  const std::vector<double>& radii_;
  const Checkpoint& checkpoint_;
  std::vector<Face> faces_;
  std::vector<int> faceCorners_;
  std::vector<std::size_t> cornerOffsets_;
  std::vector<Edge> edges_;
  std::vector<int> facesOfEdges_;
  std::vector<Source> sources_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
  BurnedSheets result_;
};

} // namespace

BurnedSheets burnSheets(const MedialAxis& axis, const std::vector<glm::dvec3>& positions,
  const std::vector<double>& radii, const Checkpoint& checkpoint)
{
  return SheetFire(axis, positions, radii, checkpoint).burn();
}

} // namespace medial
