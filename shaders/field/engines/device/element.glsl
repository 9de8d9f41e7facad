// Elements in their planes: as SiteGroup, but that each has the point nearest to the middle of the grid as its
// origin. Of an element that reaches far, this keeps the part near the grid precise.
//
// In the plane x runs along the longest edge AB, y towards the third corner C.

const int kRecord = 9; // uvec4 of an element

const uint kOwned = 127u;        // parts: face, edges AB, BC, AC, corners A, B, C
const uint kUnboundedShift = 8u; // the parts whose Voronoi regions the edges do not tell
const uint kHasFace = 1u << 16;
const uint kExists = 1u << 17; // the last group of a size may have room

struct Element
{
  vec3 origin, originLow; // their sum is the origin
  vec3 along, across;     // unit vectors of x and y
  vec4 directions;        // unit vectors from B to C, and from A to C, in the plane
  vec3 starts, ends;      // of AB, BC, AC, along these lines
  vec3 offsets;           // of the lines, across them
  uint flags;
  int site; // that names the element
};

// Where a position is in relation to the parts of an element: as ElementPosition.
struct Place
{
  float height;
  vec3 before;  // along the lines AB, BC, AC, before the start of the edge
  vec3 beyond;  // and beyond its end
  vec3 outside; // across them, away from the element
  float squared;
  float offFace; // <= 0 where the position projects into the face
};

const float kNowhere = 1e30;

// What of a place is affine in the position.
struct Coordinates
{
  vec3 along;   // the lines AB, BC, AC
  vec3 outside; // across them, away from the element
  float height;
};

// How the coordinates grow along a vector in the plane, and over it.
Coordinates growthOf(Element e, vec3 v)
{
  return Coordinates(vec3(v.x, dot(v.xy, e.directions.xy), dot(v.xy, e.directions.zw)),
    vec3(-v.y, v.x * e.directions.y - v.y * e.directions.x, v.y * e.directions.z - v.x * e.directions.w), v.z);
}

Coordinates sum(Coordinates a, Coordinates b)
{
  return Coordinates(a.along + b.along, a.outside + b.outside, a.height + b.height);
}

// p: in the plane, and over it
Coordinates coordinatesOf(Element e, vec3 p)
{
  Coordinates c = growthOf(e, p);
  c.outside += e.offsets;
  return c;
}

Place placeOf(Element e, Coordinates c)
{
  Place place;
  place.height = c.height;
  place.before = e.starts - c.along;
  place.beyond = c.along - e.ends;
  place.outside = c.outside;
  vec3 past = max(max(place.before, place.beyond), vec3(0.0));
  vec3 squared = past * past + c.outside * c.outside;
  float outside = max(max(c.outside.x, c.outside.y), c.outside.z);
  place.offFace = (e.flags & kHasFace) != 0u ? max(outside, max(place.before.x, place.beyond.x)) : kNowhere;
  place.squared =
    c.height * c.height + (place.offFace > 0.0 ? min(min(squared.x, squared.y), squared.z) : 0.0);
  return place;
}

Place placeOf(Element e, vec3 p)
{
  return placeOf(e, coordinatesOf(e, p));
}

// x + xLow: a position, local coordinates
vec3 inPlane(Element e, vec3 x, vec3 xLow)
{
  precise vec3 v = (x - e.origin) + (xLow - e.originLow);
  return vec3(dot(v, e.along), dot(v, e.across), dot(v, cross(e.along, e.across)));
}

// How the position in the plane grows along the axes.
mat3 axesInPlane(Element e)
{
  return transpose(mat3(e.along, e.across, cross(e.along, e.across)));
}

bool exists(Element e)
{
  return (e.flags & kExists) != 0u;
}
