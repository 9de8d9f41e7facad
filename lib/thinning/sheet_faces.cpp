#include "thinning/sheet_faces.h"

#include "axis/sheets/sheet_match.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace medial
{
namespace
{

bool isInside(const CubicalComplex& complex, CubeCell vertex)
{
  for (const CubeCell step : complex.cofaces(kVertexKind))
  {
    const CubeCell edge = vertex + step;
    if (complex.has(edge) && complex.cofaceCount(edge) == 1)
    {
      return false;
    }
  }
  return true;
}

/// Samples that all lie nearer to a line than this, in voxels, tell of a curve.
constexpr double kMinWidth = 0.25;

/// Whether the samples of the faces around a vertex do not lie on a line.
bool isWide(const CubicalComplex& complex, const AxisSamples& samples, CubeCell vertex)
{
  std::array<glm::dvec3, 12> points;
  std::size_t count = 0;
  for (const CubeCell face : facesAround(complex, vertex))
  {
    const int sample = complex.has(face) ? samples.find(face) : AxisSamples::kNone;
    if (sample != AxisSamples::kNone)
    {
      points[count++] = samples.point(sample).position;
    }
  }
  glm::dvec3 along(0.0);
  std::size_t start = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const glm::dvec3 way = points[i] - points[j];
      if (glm::dot(way, way) > glm::dot(along, along))
      {
        along = way;
        start = j;
      }
    }
  }
  const double length = glm::length(along);
  return std::any_of(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count),
    [&](const glm::dvec3& point)
    { return glm::length(glm::cross(point - points[start], along)) > kMinWidth * length; });
}

/// Returns the vertices that are inner points of sheets.
CubicalComplex innerPoints(const CubicalComplex& complex, const AxisSamples& samples)
{
  const std::vector<CubeCell> vertices = cellsOf(complex, kVertexKind);
  std::vector<std::uint8_t> inner(vertices.size());
  tbb::parallel_for(std::size_t{ 0 }, vertices.size(),
    [&](std::size_t i) {
      inner[i] = isInside(complex, vertices[i]) && isWide(complex, samples, vertices[i]) ? 1 : 0;
    });
  CubicalComplex points(complex.size());
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (inner[i] != 0)
    {
      points.insert(vertices[i]);
    }
  }
  return points;
}

bool isInSheet(const CubicalComplex& complex, const CubicalComplex& inner, CubeCell face)
{
  const int axis = CubicalComplex::kind(face) - kFaceKind;
  const std::size_t corner = CubicalComplex::index(face);
  const auto u = static_cast<std::size_t>(complex.stride((axis + 1) % 3));
  const auto v = static_cast<std::size_t>(complex.stride((axis + 2) % 3));
  return (inner.bits(corner) | inner.bits(corner + u) | inner.bits(corner + v) |
           inner.bits(corner + u + v)) != 0;
}

/// Calls visit(face) for the faces of a complex that share an edge with one, and for itself.
template <typename Visit>
void forEachBeside(const CubicalComplex& complex, CubeCell face, const Visit& visit)
{
  for (const CubeCell toEdge : complex.faces(CubicalComplex::kind(face)))
  {
    const CubeCell edge = face + toEdge;
    for (const CubeCell toFace : complex.cofaces(CubicalComplex::kind(edge)))
    {
      if (complex.has(edge + toFace))
      {
        visit(edge + toFace);
      }
    }
  }
}

/// Adds exact faces that are joined to sheets through edges, directly or through others.
/// @param inSheet for each face not 0 if it is part of a sheet.
void addJoined(const CubicalComplex& complex, const std::vector<CubeCell>& faces,
  const AxisSamples& samples, const std::vector<std::uint8_t>& exact,
  std::vector<std::uint8_t>& inSheet)
{
  constexpr std::size_t kSheet = std::numeric_limits<std::size_t>::max();
  constexpr std::size_t kNeither = kSheet - 1;
  std::vector<std::size_t> others(exact.size(), kNeither); // faces by their samples
  tbb::parallel_for(std::size_t{ 0 }, faces.size(),
    [&](std::size_t i)
    {
      const auto sample = static_cast<std::size_t>(samples.find(faces[i]));
      others[sample] = inSheet[i] != 0 ? kSheet : exact[sample] != 0 ? i : kNeither;
    });
  const auto at = [&](CubeCell face)
  {
    const int sample = samples.find(face);
    return sample == AxisSamples::kNone ? kNeither : others[static_cast<std::size_t>(sample)];
  };
  std::vector<std::uint8_t> beside(faces.size());
  tbb::parallel_for(std::size_t{ 0 }, faces.size(),
    [&](std::size_t i)
    {
      if (inSheet[i] == 0 && at(faces[i]) != kNeither)
      {
        forEachBeside(complex, faces[i],
          [&](CubeCell face) { beside[i] |= at(face) == kSheet ? 1 : 0; });
      }
    });
  std::vector<std::size_t> front;
  const auto join = [&](std::size_t i)
  {
    inSheet[i] = 1;
    others[static_cast<std::size_t>(samples.find(faces[i]))] = kSheet;
    front.push_back(i);
  };
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (beside[i] != 0)
    {
      join(i);
    }
  }
  for (std::size_t k = 0; k < front.size(); ++k)
  {
    forEachBeside(complex, faces[front[k]],
      [&](CubeCell face)
      {
        const std::size_t other = at(face);
        if (other < kNeither)
        {
          join(other);
        }
      });
  }
}

/// Whether a face is a small piece of a sheet: its bisector is exact, and all faces at its corners
/// are on the same sheet. Around a curve they lie in all directions.
bool isPiece(const CubicalComplex& complex, const AxisSamples& samples,
  const std::vector<std::uint8_t>& exact, CubeCell face)
{
  const int sample = samples.find(face);
  if (exact[static_cast<std::size_t>(sample)] == 0)
  {
    return false;
  }
  const PairDirections here = directionsOf(samples.point(sample));
  const int axis = CubicalComplex::kind(face) - kFaceKind;
  const CubeCell corner = face - CubicalComplex::kind(face);
  const CubeCell u = 8 * complex.stride((axis + 1) % 3);
  const CubeCell v = 8 * complex.stride((axis + 2) % 3);
  for (const CubeCell vertex : { corner, corner + u, corner + v, corner + u + v })
  {
    for (const CubeCell other : facesAround(complex, vertex))
    {
      const int there = complex.has(other) ? samples.find(other) : AxisSamples::kNone;
      if (there != AxisSamples::kNone && !onOneSheet(here, directionsOf(samples.point(there))))
      {
        return false;
      }
    }
  }
  return true;
}

} // namespace

SheetSplit splitSheets(const CubicalComplex& complex, const std::vector<CubeCell>& faces,
  const AxisSamples& samples, const std::vector<std::uint8_t>& exact)
{
  std::vector<std::uint8_t> inSheet(faces.size());
  {
    const CubicalComplex inner = innerPoints(complex, samples);
    tbb::parallel_for(std::size_t{ 0 }, faces.size(),
      [&](std::size_t i) { inSheet[i] = isInSheet(complex, inner, faces[i]) ? 1 : 0; });
  }
  addJoined(complex, faces, samples, exact, inSheet);
  tbb::parallel_for(std::size_t{ 0 }, faces.size(),
    [&](std::size_t i)
    { inSheet[i] = inSheet[i] != 0 || isPiece(complex, samples, exact, faces[i]) ? 1 : 0; });
  SheetSplit split;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    (inSheet[i] != 0 ? split.sheets : split.strips).push_back(faces[i]);
  }
  return split;
}

SheetSplit splitSheets(const glm::ivec3& size, const std::vector<CubeCell>& faces,
  const AxisSamples& samples, const std::vector<std::uint8_t>& exact)
{
  return splitSheets(closureOf(size, faces), faces, samples, exact);
}

} // namespace medial
