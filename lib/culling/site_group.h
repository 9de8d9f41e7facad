#pragma once

#include "base/simd.h"
#include "medial/mesh_connectivity.h"
#include "sites/site_set.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace medial
{

/// The sites of an element, as bits: its face, its edges AB, BC, AC, its corners A, B, C.
enum SitePart
{
  kFacePart = 1,
  kEdgePart = 2,    ///< AB; shifted by 1 and 2: BC, AC
  kVertexPart = 16, ///< A; shifted by 1 and 2: B, C
};

/// Eight neighbouring elements of a surface, side by side. An element is a triangle with its edges
/// and vertices, or an edge or a vertex that belongs to no triangle. Sites that elements share are
/// owned by one of them.
///
/// Each element is described in its plane. The origin is the start A of its longest edge AB, x runs
/// along this edge, and y towards the third corner C.
struct alignas(32) SiteGroup
{
  static constexpr int kSize = kLanes;
  using Lanes = std::array<float, kSize>;
  using Lanes3 = std::array<Lanes, 3>;
  using IntLanes = std::array<std::int32_t, kSize>;

  // First what distances need, so that it lies together.
  Lanes3 start;                  ///< A, relative to `origin`
  Lanes3 along;                  ///< unit vector of x
  Lanes3 across;                 ///< unit vector of y
  Lanes3 normal;                 ///< unit vector orthogonal to both
  Lanes3 lengths;                ///< of AB, BC, AC
  std::array<Lanes, 2> fromB;    ///< unit vector from B to C, in the plane
  std::array<Lanes, 2> fromA;    ///< unit vector from A to C, in the plane
  Lanes withoutFace;             ///< 0, or infinite where the element has no active face
  IntLanes elements;             ///< sites that name them, ascending; the last one fills
                                 ///< the rest, and owns nothing there
  alignas(32) glm::dvec3 origin; ///< local coordinates
  float extent;                  ///< largest distance of a corner from the origin
  alignas(32) Lanes3 foldCosine; ///< of the angle by which the neighbour at AB, BC, AC bends from
  Lanes3 foldSine;               ///< the plane towards the normal; both are 0 without a neighbour
  std::array<Lanes3, 3> away;    ///< unit vectors of the edges at A, B, C that lead away from the
                              ///< element, for ElementPosition::alongAway(); 0 where there is none
  IntLanes owned;                          ///< active sites, as bits of SitePart
  IntLanes unbounded;                      ///< those whose Voronoi regions the edges do not tell
  std::array<std::uint8_t, kSize> longest; ///< which edge AB is, as in SiteSet::faceEdges()

  /// Sets nothing, so that many groups can be made without a pass over their memory.
  SiteGroup() {}

  /// Copies an element. Its start stays relative to the origin of `from`.
  void copy(int to, const SiteGroup& from, int lane);

  /// Returns a position relative to the origin.
  glm::vec3 toGroup(const glm::dvec3& x) const { return glm::vec3(x - origin); }
};

/// Which element owns the sites that several share, and which faces meet at edges.
struct SharedSites
{
  static constexpr int kNone = -1;

  std::vector<int> edgeOwners;       ///< element of every edge
  std::vector<int> vertexOwners;     ///< element of every vertex
  std::vector<glm::ivec2> edgeFaces; ///< the first two active faces of every edge, or kNone
  std::vector<char>
    open; ///< of every vertex: whether an edge there has not two active faces, one each way
  std::vector<char> degenerate; ///< of every vertex: whether a face or an edge there is not active
  const IncidenceLists& pointEdges; ///< of the connectivity

  /// @param connectivity must outlive this.
  SharedSites(const SiteSet& sites, const MeshConnectivity& connectivity);

  /// Returns the smallest cosine between an axis and the normals of the faces at a group's sites.
  /// @return -1 if the surface ends or branches there, or turns its other side out.
  double minCosine(const SiteSet& sites, const SiteGroup& group, const glm::dvec3& axis) const;

  /// Returns all elements, by the sites that name them: faces, and edges and vertices of no face.
  std::vector<int> elements(const SiteSet& sites) const;
};

/// Builds a group.
/// @param elements ascending.
/// @param count in [1, SiteGroup::kSize].
SiteGroup makeSiteGroup(const SiteSet& sites, const SharedSites& shared, const int* elements,
  int count);

/// Returns the site of a part of an element.
/// @param part number of its bit in SitePart.
int siteOf(const SiteSet& sites, const SiteGroup& group, int lane, int part);

/// Reads the members of a group for all of its elements.
struct AllElements
{
  MEDIAL_INLINE Float8 operator()(const SiteGroup::Lanes& lanes) const
  {
    return loaded(lanes.data());
  }
  MEDIAL_INLINE Int8 operator()(const SiteGroup::IntLanes& lanes) const
  {
    return loadedInts(lanes.data());
  }
};

/// Reads the members of a group for one of its elements, the same in all lanes.
struct OneElement
{
  int lane;

  MEDIAL_INLINE Float8 operator()(const SiteGroup::Lanes& lanes) const
  {
    return splat(lanes[lane]);
  }
  MEDIAL_INLINE Int8 operator()(const SiteGroup::IntLanes& lanes) const
  {
    return Int8{} + lanes[lane];
  }
};

/// Where positions are in the planes of elements.
struct alignas(32) PlanePosition
{
  Float8 x, y;   ///< in the plane, as SiteGroup says
  Float8 height; ///< over it

  PlanePosition() = default;
  /// @param offset of the positions from the elements' A, or any vector; by axis.
  /// @param of AllElements, or OneElement.
  template <typename Of>
  MEDIAL_INLINE PlanePosition(const SiteGroup& group, const Of& of,
    const std::array<Float8, 3>& offset)
  {
    const auto component = [&](const SiteGroup::Lanes3& axis)
    { return offset[0] * of(axis[0]) + offset[1] * of(axis[1]) + offset[2] * of(axis[2]); };
    x = component(group.along);
    y = component(group.across);
    height = component(group.normal);
  }
};

/// Where positions are in relation to the parts of elements.
struct alignas(32) ElementPosition
{
  Float8 height;     ///< over the planes
  Float8 outside[3]; ///< distance in the plane from the lines through AB, BC, AC, away from C, A, B
  Float8 before[3];  ///< distance along these lines, before the start of the edge
  Float8 beyond[3];  ///< and beyond its end
  Float8 squared;    ///< distance from the element
  Float8 offFace;    ///< <= 0 where the position projects into the face

  /// @param of AllElements, or OneElement.
  template <typename Of>
  MEDIAL_INLINE ElementPosition(const SiteGroup& group, const Of& of, const PlanePosition& p)
    : height(p.height)
  {
    const auto setEdge = [&](int edge, Float8 t, Float8 s)
    {
      before[edge] = -t;
      beyond[edge] = t - of(group.lengths[edge]);
      outside[edge] = s;
      const Float8 past = max(max(before[edge], beyond[edge]), Float8{});
      const Float8 squaredEdge = past * past + s * s;
      squared = edge == 0 ? squaredEdge : min(squared, squaredEdge);
    };
    setEdge(0, p.x, -p.y);
    const Float8 qx = p.x - of(group.lengths[0]);
    const Float8 bx = of(group.fromB[0]);
    const Float8 by = of(group.fromB[1]);
    setEdge(1, qx * bx + p.y * by, qx * by - p.y * bx);
    const Float8 ax = of(group.fromA[0]);
    const Float8 ay = of(group.fromA[1]);
    setEdge(2, p.x * ax + p.y * ay, p.y * ax - p.x * ay);
    // Beyond an acute corner, rounding turns the space between the long edges into a strip; the
    // ends of AB cut it off.
    offFace = max(max(max(outside[0], outside[1]), max(outside[2], of(group.withoutFace))),
      max(before[0], beyond[0]));
    squared = height * height + (offFace > 0.0f ? squared : Float8{});
  }

  /// Returns the distance from a corner along the edge there that leads away from the element.
  /// @param corner 0, 1, 2 for A, B, C.
  template <typename Of>
  MEDIAL_INLINE Float8 alongAway(const SiteGroup& group, const Of& of, int corner) const
  {
    const SiteGroup::Lanes3& away = group.away[corner];
    const Float8 past = corner == 0 ? before[0] : corner == 1 ? beyond[0] : beyond[2];
    return of(away[0]) * past + of(away[1]) * outside[corner == 2 ? 2 : 0] + of(away[2]) * height;
  }

  /// A position in relation to all elements of a group.
  /// @param x relative to the group's origin.
  MEDIAL_INLINE ElementPosition(const SiteGroup& group, const glm::vec3& x)
    : ElementPosition(group, AllElements(),
        PlanePosition(group, AllElements(),
          { x.x - loaded(group.start[0].data()), x.y - loaded(group.start[1].data()),
            x.z - loaded(group.start[2].data()) }))
  {
  }
};

/// Returns the owned sites that can hold the closest points of positions in balls, as bits of
/// SitePart: those whose Voronoi regions meet the ball, as far as the element, one neighbour at
/// each edge and one more edge at each corner bound them.
/// @param of AllElements, or OneElement.
template <typename Of>
MEDIAL_INLINE Int8 partsNear(const SiteGroup& group, const Of& of, const ElementPosition& centre,
  float radius)
{
  const Float8 r = splat(radius);
  const Float8 withoutFace = of(group.withoutFace);
  Int8 parts = (centre.offFace <= r) & static_cast<int>(kFacePart);
  for (int edge = 0; edge < 3; ++edge)
  {
    const Float8 intoNeighbour =
      of(group.foldCosine[edge]) * centre.outside[edge] + of(group.foldSine[edge]) * centre.height;
    parts |= (centre.outside[edge] + withoutFace >= -r) & (intoNeighbour <= r) &
      (max(centre.before[edge], centre.beyond[edge]) <= r) & (kEdgePart << edge);
  }
  const Float8 beyondCorner[3][2] = { { centre.before[0], centre.before[2] },
    { centre.beyond[0], centre.before[1] }, { centre.beyond[1], centre.beyond[2] } };
  for (int corner = 0; corner < 3; ++corner)
  {
    parts |= (min(beyondCorner[corner][0], beyondCorner[corner][1]) >= -r) &
      (centre.alongAway(group, of, corner) <= r) & (kVertexPart << corner);
  }
  return (parts | of(group.unbounded)) & of(group.owned);
}

} // namespace medial
