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

// p: in the plane, and over it
Place placeOf(Element e, vec3 p)
{
  Place place;
  vec3 t = vec3(p.x, dot(p.xy, e.directions.xy), dot(p.xy, e.directions.zw));
  place.height = p.z;
  place.before = e.starts - t;
  place.beyond = t - e.ends;
  place.outside = e.offsets +
    vec3(-p.y, p.x * e.directions.y - p.y * e.directions.x, p.y * e.directions.z - p.x * e.directions.w);
  vec3 past = max(max(place.before, place.beyond), vec3(0.0));
  vec3 squared = past * past + place.outside * place.outside;
  float outside = max(max(place.outside.x, place.outside.y), place.outside.z);
  place.offFace = (e.flags & kHasFace) != 0u ? max(outside, max(place.before.x, place.beyond.x)) : kNowhere;
  place.squared =
    p.z * p.z + (place.offFace > 0.0 ? min(min(squared.x, squared.y), squared.z) : 0.0);
  return place;
}

// x + xLow: a position, local coordinates
vec3 inPlane(Element e, vec3 x, vec3 xLow)
{
  precise vec3 v = (x - e.origin) + (xLow - e.originLow);
  return vec3(dot(v, e.along), dot(v, e.across), dot(v, cross(e.along, e.across)));
}

bool exists(Element e)
{
  return (e.flags & kExists) != 0u;
}
