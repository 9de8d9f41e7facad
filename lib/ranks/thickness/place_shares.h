#pragma once

#include "base/checkpoint.h"
#include "ranks/thickness/measured_places.h"
#include "thickness/place_values.h"

namespace medial
{

/// The thickness at the points and triangles of this rank's share of a distributed surface.
class PlaceShares
{
public:
  /// @param surface must outlive this.
  /// @param faces whether triangles have values.
  PlaceShares(const Communicator& communicator, const DistributedSurface& surface, bool faces);

  const PlaceValues& points() const { return points_; }
  const PlaceValues& faces() const { return faces_; }

  /// Takes what ranks have measured of all places. Every rank calls it.
  void set(Communicator& communicator, const MeasuredPlaces& measured);
  /// Gives places without a wall the value of the nearest place with one, as extendWalls() does.
  /// The first rank gets the triangles with such places, and no others. Every rank calls it.
  void extendWalls(Communicator& communicator, const Checkpoint& checkpoint);
  /// Keeps the smaller values of two sides.
  void takeSmaller(const PlaceShares& side);

  /// Returns the values of points, by their numbers. Every rank calls it.
  PlaceValues ofPoints(Communicator& communicator, const std::vector<int>& points) const;
  /// Returns the values of the triangles of this rank's piece. Every rank calls it.
  /// @param triangles how many it has.
  PlaceValues ofPiece(Communicator& communicator, std::size_t triangles) const;

private:
  const DistributedSurface& surface_;
  int firstPoint_;
  PlaceValues points_;
  PlaceValues faces_; ///< in the order of the surface's faces(); empty if they have none
};

} // namespace medial
