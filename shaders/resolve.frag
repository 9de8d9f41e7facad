#version 450 core
// Exact closest point, signed distance and site from the id that the depth test left.
//
// in   closestSite   R32I atlas of site ids, -1 where no polygon fell
//      storage       the mesh in frame coordinates
// out  displacement  xyz: vector to the closest point; w: signed distance; frame units
//      site          the site whose interior holds the closest point; -1 if none
//      holes         number of grid points without a site

layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) readonly buffer Faces { ivec4 faces[]; };         // corners
layout(std430, binding = 2) readonly buffer FaceEdges { ivec4 faceEdges[]; }; // edge numbers
layout(std430, binding = 3) readonly buffer Edges { ivec2 edges[]; };         // end points
layout(std430, binding = 4) readonly buffer Normals { vec4 normals[]; };      // pseudonormals
layout(std430, binding = 5) buffer Holes { uint holes; };

uniform isampler2D closestSite;
uniform ivec2 sliceSize;  // grid points of a slice
uniform int columns;      // slots of the atlas in a row
uniform int firstSlot;    // slots [firstSlot, endSlot) are in use
uniform int endSlot;
uniform vec3 origin;      // frame position of the grid point in pixel (0,0) of slot 0
uniform vec3 spacing;     // frame distance of neighbouring grid points
uniform int firstEdge;    // first edge site
uniform int firstVertex;  // first vertex site
uniform int signedField;  // 0: unsigned
uniform float orientation; // -1 where the pseudonormals are turned against the faces' winding

layout(location = 0) out vec4 displacement;
layout(location = 1) out int site;

struct SitePoint
{
  int site;
  vec3 vector; // from the grid point to the closest point
};

SitePoint closestOnEdge(int edge, vec3 x)
{
  ivec2 ends = edges[edge];
  vec3 p = points[ends.x].xyz;
  vec3 q = points[ends.y].xyz;
  vec3 along = q - p;
  float t = dot(x - p, along) / dot(along, along);
  if (t <= 0.0)
  {
    return SitePoint(firstVertex + ends.x, p - x);
  }
  if (t >= 1.0)
  {
    return SitePoint(firstVertex + ends.y, q - x);
  }
  return SitePoint(firstEdge + edge, (p - x) + t * along);
}

SitePoint nearer(SitePoint a, SitePoint b)
{
  return dot(b.vector, b.vector) < dot(a.vector, a.vector) ? b : a;
}

// x lies on the inner side of the edge p-q of a face with this normal
bool inner(vec3 p, vec3 q, vec3 normal, vec3 x)
{
  return dot(cross(q - p, normal), x - p) < 0.0;
}

SitePoint closestOnFace(int face, vec3 x)
{
  ivec3 corners = faces[face].xyz;
  vec3 a = points[corners.x].xyz;
  vec3 b = points[corners.y].xyz;
  vec3 c = points[corners.z].xyz;
  vec3 normal = normals[face].xyz * orientation;
  if (inner(a, b, normal, x) && inner(b, c, normal, x) && inner(c, a, normal, x))
  {
    return SitePoint(face, dot(a - x, normal) * normal);
  }
  // The face's bound is dilated a little, so the point may belong to the border.
  ivec3 border = faceEdges[face].xyz;
  return nearer(closestOnEdge(border.x, x), nearer(closestOnEdge(border.y, x), closestOnEdge(border.z, x)));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 cell = pixel / sliceSize;
  int slot = cell.y * columns + cell.x;
  if (slot < firstSlot || slot >= endSlot || cell.x >= columns)
  {
    discard;
  }
  int winner = texelFetch(closestSite, pixel, 0).x;
  if (winner < 0)
  {
    atomicAdd(holes, 1u);
    displacement = vec4(0.0);
    site = -1;
    return;
  }
  vec3 x = origin + vec3(pixel - cell * sliceSize, slot) * spacing;
  SitePoint closest;
  if (winner < firstEdge)
  {
    closest = closestOnFace(winner, x);
  }
  else if (winner < firstVertex)
  {
    closest = closestOnEdge(winner - firstEdge, x);
  }
  else
  {
    closest = SitePoint(winner, points[winner - firstVertex].xyz - x);
  }
  float distance = length(closest.vector);
  bool inside = signedField != 0 && dot(normals[closest.site].xyz, closest.vector) > 0.0;
  displacement = vec4(closest.vector, inside ? -distance : distance);
  site = closest.site;
}
