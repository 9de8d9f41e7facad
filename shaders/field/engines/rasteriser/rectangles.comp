#version 450 core
// Finds what cuts a site's rectangle into polygons that bound its Voronoi region (paper, section 3), with the bounds
// of SiteBounds, and the affine functions that the distance is made of. One invocation does a rectangle of one layer
// of tiles.
//
// in   rectangles  by sevens: site, first grid point, last grid point
// out  instances   what polygons.vert draws
#include "../device/numbering.glsl"
#include "../device/axes.glsl"
#include "../device/mesh.glsl"
#include "../device/faces.glsl"

const int kSides = 8; // clip distances that every driver has

// Affine functions are over the grid points of the rectangle: x, y, z: growth along the axes; w: at its first.
struct Instance
{
  ivec4 place;     // site; x and y of the first grid point, as halves; its z; bytes: width and height less one,
                   // and the slices that have a part inside every half-space, as bits
  vec4 vectors[3]; // to the site, in its own axes: only the length matters
  vec4 sides[kSides];
};

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Rectangles { int rectangles[]; };
layout(std430, binding = 4) writeonly buffer Instances { Instance instances[]; };

uniform int count;
uniform ivec3 slabMin;
uniform dvec3 exactFirst; // grid point (0,0,0)
uniform dvec3 exactSpacing;
uniform float roundingMargin; // of single precision, local units
uniform float snappingMargin; // of what drivers round pixels to

dvec3 corner = dvec3(0.0LF); // first grid point of the rectangle
vec3 size = vec3(0.0);       // of its grid points
int slices = 0;              // that do not lie entirely outside a half-space, as bits
vec4 sides[kSides];
int used = 0;

// The distance beyond the plane through a point.
vec4 beyond(dvec3 normal, dvec3 point)
{
  return vec4(vec3(normal * exactSpacing), float(dot(normal, corner - point)));
}

// Adds the half-space behind the plane through a point. Those after the first eight that cut the rectangle only tell
// slices that are not needed: leaving out a harmless one is exact.
// harmless: distances are too small nowhere beyond the plane, so that it may be moved outwards
void addSide(dvec3 normal, dvec3 point, bool harmless)
{
  vec4 side = beyond(normal, point);
  side.w -= roundingMargin + (harmless ? snappingMargin * length(side.xy) : 0.0);
  // The rectangle extends half a pixel beyond its grid points.
  float margin = 0.5 * (abs(side.x) + abs(side.y));
  vec3 reach = side.xyz * size;
  vec2 low = min(reach.xy, vec2(0.0));
  vec3 high = max(reach, vec3(0.0));
  for (int slice = 0; slice <= int(size.z); ++slice)
  {
    bool outside = side.w + low.x + low.y + float(slice) * side.z - margin > 0.0;
    slices &= outside ? ~(1 << slice) : ~0;
  }
  bool cuts = side.w + high.x + high.y + high.z + margin > 0.0;
  if (cuts && used < kSides)
  {
    sides[used++] = side;
  }
}

dvec3 unitOrZero(dvec3 v)
{
  double size = length(v);
  return size > 0.0LF ? v / size : dvec3(0.0LF);
}

// The planes across the ends of a segment.
void addEnds(dvec3 p, dvec3 q)
{
  dvec3 along = unitOrZero(q - p);
  addSide(-along, p, false);
  addSide(along, q, false);
}

// The outward conormal at edge i of a face.
dvec3 conormal(int face, int i)
{
  ivec3 corners = faceCorners(face);
  return normalize(cross(pointAt(corners[(i + 1) % 3]) - pointAt(corners[i]), faceNormal(face)));
}

void addFaceSides(int face)
{
  ivec3 corners = faceCorners(face);
  for (int i = 0; i < 3; ++i)
  {
    addSide(conormal(face, i), pointAt(corners[i]), false);
  }
  // They cut off what the margins add beyond acute corners.
  int longest = longestEdge(face);
  addEnds(pointAt(corners[longest]), pointAt(corners[(longest + 1) % 3]));
}

void addEdgeSides(int edge)
{
  ivec2 ends = edgeEnds(edge);
  dvec3 p = pointAt(ends.x);
  dvec3 q = pointAt(ends.y);
  if (p == q)
  {
    slices = 0; // rounding leaves nothing of it, and its vectors are not numbers
    return;
  }
  addEnds(p, q);
  ivec2 range = edgeFaceRange(edge);
  for (int i = range.x; i < range.y; ++i)
  {
    int face = connectivity[i];
    if (faceActive(face))
    {
      ivec3 border = faceEdges(face);
      int itself = border.x == edge ? 0 : (border.y == edge ? 1 : 2);
      addSide(-conormal(face, itself), pointAt(faceCorners(face)[itself]), true);
    }
  }
}

// Edges that are far from each other in the list come first: neighbours may well have nearly the same half-space.
void addVertexSides(int vertex)
{
  dvec3 p = pointAt(vertex);
  ivec2 range = vertexEdgeRange(vertex);
  int stride = (range.y - range.x + kSides - 1) / kSides;
  for (int i = 0; i < kSides * stride; ++i)
  {
    int at = range.x + i % kSides * stride + i / kSides;
    if (at < range.y)
    {
      ivec2 ends = edgeEnds(connectivity[at]);
      addSide(unitOrZero(pointAt(ends.x == vertex ? ends.y : ends.x) - p), p, true);
    }
  }
}

// One along the normal of a face.
void setFaceVectors(int face, out vec4 vectors[3])
{
  vectors[0] = beyond(faceNormal(face), pointAt(faceCorners(face).x));
  vectors[1] = vec4(0.0);
  vectors[2] = vec4(0.0);
}

// Two across an edge.
void setEdgeVectors(int edge, out vec4 vectors[3])
{
  ivec2 ends = edgeEnds(edge);
  dvec3 p = pointAt(ends.x);
  dvec3 along = unitOrZero(pointAt(ends.y) - p);
  dvec3 other = abs(along.x) < 0.6LF ? dvec3(1.0LF, 0.0LF, 0.0LF) : dvec3(0.0LF, 1.0LF, 0.0LF);
  dvec3 across = normalize(cross(along, other));
  vectors[0] = beyond(across, p);
  vectors[1] = beyond(cross(along, across), p);
  vectors[2] = vec4(0.0);
}

// Three for a vertex.
void setVertexVectors(int vertex, out vec4 vectors[3])
{
  dvec3 p = pointAt(vertex);
  for (int axis = 0; axis < 3; ++axis)
  {
    vectors[axis] = beyond(unitVector(axis), p);
  }
}

void main()
{
  int i = int(itemNumber());
  if (i >= count)
  {
    return;
  }
  int at = 7 * i;
  int site = rectangles[at];
  ivec3 low = ivec3(rectangles[at + 1], rectangles[at + 2], rectangles[at + 3]);
  ivec3 high = ivec3(rectangles[at + 4], rectangles[at + 5], rectangles[at + 6]);
  corner = exactFirst + dvec3(low) * exactSpacing;
  size = vec3(high - low);
  slices = (2 << int(size.z)) - 1;
  for (int side = 0; side < kSides; ++side)
  {
    sides[side] = vec4(0.0, 0.0, 0.0, -1.0);
  }
  vec4 vectors[3];
  if (site < faceCount)
  {
    addFaceSides(site);
    setFaceVectors(site, vectors);
  }
  else if (site < firstVertex())
  {
    addEdgeSides(site - faceCount);
    setEdgeVectors(site - faceCount, vectors);
  }
  else
  {
    addVertexSides(site - firstVertex());
    setVertexVectors(site - firstVertex(), vectors);
  }
  ivec3 first = low - slabMin;
  ivec2 last = high.xy - low.xy;
  instances[i].place = ivec4(site, first.x | first.y << 16, first.z, last.x | last.y << 8 | slices << 16);
  instances[i].vectors = vectors;
  instances[i].sides = sides;
}
