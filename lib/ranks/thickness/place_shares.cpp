#include "ranks/thickness/place_shares.h"

#include "ranks/surface/surface_part.h"
#include "thickness/wall_extension.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace medial
{
namespace
{

struct Value
{
  float value; ///< as PlaceValues
  char atEdge;
  char opens;
};

Value valueOf(const PlaceValues& values, std::size_t place)
{
  return { values.values[place], values.atEdge[place], values.opens[place] };
}

void setValue(PlaceValues& values, std::size_t place, const Value& value)
{
  values.values[place] = value.value;
  values.atEdge[place] = value.atEdge;
  values.opens[place] = value.opens;
}

/// A triangle with what is known of it.
struct StripFace
{
  FaceRecord face;
  Value centre;
  std::array<Value, 3> corners;

  bool isComplete() const
  {
    return !std::isnan(centre.value) &&
      std::none_of(corners.begin(), corners.end(),
        [](const Value& at) { return std::isnan(at.value); });
  }
};

/// Extends walls over triangles, which come in any order.
MeasuredPlaces extended(const std::vector<StripFace>& strips, const Checkpoint& checkpoint)
{
  std::vector<FaceRecord> records;
  std::transform(strips.begin(), strips.end(), std::back_inserter(records),
    [](const StripFace& strip) { return strip.face; });
  // Its places come in the order of the whole, which decides between places at the same distance.
  const SurfacePart part(std::move(records));
  PlaceValues points(part.points().size());
  PlaceValues faces(part.faces().size());
  for (const StripFace& strip : strips)
  {
    const int face = part.faceOf(strip.face.face);
    setValue(faces, static_cast<std::size_t>(face), strip.centre);
    for (int i = 0; i < 3; ++i)
    {
      setValue(points, static_cast<std::size_t>(part.mesh().triangles[face][i]), strip.corners[i]);
    }
  }
  medial::extendWalls(part.mesh(), part.connectivity(), checkpoint, points, faces);
  MeasuredPlaces result;
  for (std::size_t i = 0; i < part.points().size(); ++i)
  {
    result.points.push_back(
      { part.points()[i], points.values[i], points.atEdge[i], points.opens[i] });
  }
  for (std::size_t i = 0; i < part.faces().size(); ++i)
  {
    result.faces.push_back({ part.faces()[i], faces.values[i], faces.atEdge[i], faces.opens[i] });
  }
  return result;
}

} // namespace

PlaceShares::PlaceShares(const Communicator& communicator, const DistributedSurface& surface,
  bool faces)
  : surface_(surface)
  , firstPoint_(0)
  , points_(0)
  , faces_(faces ? surface.faces().size() : 0)
{
  const auto isBefore = [&](int point, int rank) { return surface.homeOfPoint(point) < rank; };
  const auto firstOf = [&](int rank)
  {
    int low = 0;
    int high = surface.pointCount();
    while (low < high)
    {
      const int middle = low + (high - low) / 2;
      (isBefore(middle, rank) ? low : high) = isBefore(middle, rank) ? middle + 1 : middle;
    }
    return low;
  };
  firstPoint_ = firstOf(communicator.rank());
  points_ = PlaceValues(static_cast<std::size_t>(firstOf(communicator.rank() + 1) - firstPoint_));
}

void PlaceShares::set(Communicator& communicator, const MeasuredPlaces& measured)
{
  for (const PlaceValue& value : delivered(communicator, measured.points,
         [&](const PlaceValue& sent) { return surface_.homeOfPoint(sent.place); }))
  {
    setValue(points_, static_cast<std::size_t>(value.place - firstPoint_),
      { value.value, value.atEdge, value.opens });
  }
  for (const PlaceValue& value : delivered(communicator, measured.faces,
         [&](const PlaceValue& sent) { return surface_.homeOfFace(sent.place); }))
  {
    setValue(faces_, surface_.indexOf(value.place), { value.value, value.atEdge, value.opens });
  }
}

void PlaceShares::extendWalls(Communicator& communicator, const Checkpoint& checkpoint)
{
  std::vector<int> corners;
  for (const FaceRecord& face : surface_.faces())
  {
    corners.insert(corners.end(), face.corners.begin(), face.corners.end());
  }
  const PlaceValues atCorners = this->ofPoints(communicator, corners);
  std::vector<StripFace> strips;
  for (std::size_t i = 0; i < surface_.faces().size(); ++i)
  {
    const StripFace strip{ surface_.faces()[i], valueOf(faces_, i),
      { valueOf(atCorners, 3 * i), valueOf(atCorners, 3 * i + 1), valueOf(atCorners, 3 * i + 2) } };
    if (!strip.isComplete())
    {
      strips.push_back(strip);
    }
  }
  strips = delivered(communicator, strips, [](const StripFace&) { return 0; });
  this->set(communicator, strips.empty() ? MeasuredPlaces() : extended(strips, checkpoint));
}

void PlaceShares::takeSmaller(const PlaceShares& side)
{
  medial::takeSmaller(side.points_, points_);
  medial::takeSmaller(side.faces_, faces_);
}

PlaceValues PlaceShares::ofPoints(Communicator& communicator, const std::vector<int>& points) const
{
  PlaceValues result(points.size());
  std::size_t next = 0;
  for (const Value& value :
    answered(
      communicator, points, [&](int point) { return surface_.homeOfPoint(point); },
      [&](int point) { return valueOf(points_, static_cast<std::size_t>(point - firstPoint_)); }))
  {
    setValue(result, next++, value);
  }
  return result;
}

PlaceValues PlaceShares::ofPiece(Communicator& communicator, std::size_t triangles) const
{
  struct Sent
  {
    DistributedSurface::Origin to;
    Value value;
  };
  std::vector<Sent> sent;
  for (std::size_t i = 0; i < faces_.values.size(); ++i)
  {
    sent.push_back({ surface_.origins()[i], valueOf(faces_, i) });
  }
  PlaceValues result(triangles);
  for (const Sent& received :
    delivered(communicator, sent, [](const Sent& value) { return value.to.rank; }))
  {
    setValue(result, static_cast<std::size_t>(received.to.triangle), received.value);
  }
  return result;
}

} // namespace medial
