#version 450 core
// Exact closest point, signed distance and site from the site id that the depth test left.
//
// in   closestSite   R32I atlas of site ids, -1 where there was no polygon
//      storage       the mesh in local coordinates; w of a face's normal: its plane's offset
// out  displacement  xyz: vector to the closest point; w: signed distance; local units
//      site          the site whose interior contains the closest point; -1 if none
//      holes         number of grid points without a site

// Lines and planes are stored by where they pass the origin, which is in the middle of the grid:
// single precision then suffices for meshes much larger than the grid.
struct Line
{
  vec4 foot;      // xyz: the line's point nearest to the origin; w: where the edge starts
  vec4 direction; // xyz: unit vector; w: where the edge ends
};

layout(std430, binding = 0) readonly buffer Points { vec4 points[]; };
layout(std430, binding = 1) readonly buffer Faces { ivec4 faces[]; };         // corners
layout(std430, binding = 2) readonly buffer FaceEdges { ivec4 faceEdges[]; }; // edge numbers
layout(std430, binding = 3) readonly buffer Edges { ivec2 edges[]; };         // end points
layout(std430, binding = 4) readonly buffer Lines { Line lines[]; };          // of the edges
layout(std430, binding = 5) readonly buffer Normals { vec4 normals[]; };      // pseudonormals
layout(std430, binding = 6) buffer Holes { uint holes; };

uniform isampler2D closestSite;
uniform ivec2 sliceSize;  // grid points of a slice
uniform int columns;      // slots of the atlas in a row
uniform int firstSlot;    // slots [firstSlot, endSlot) are in use
uniform int endSlot;
uniform vec3 origin;      // grid point in pixel (0,0) of slot 0, local coordinates
uniform vec3 spacing;     // distance of neighbouring grid points, local units
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
  Line line = lines[edge];
  float t = dot(line.direction.xyz, x);
  if (t <= line.foot.w)
  {
    return SitePoint(firstVertex + ends.x, points[ends.x].xyz - x);
  }
  if (t >= line.direction.w)
  {
    return SitePoint(firstVertex + ends.y, points[ends.y].xyz - x);
  }
  return SitePoint(firstEdge + edge, line.foot.xyz + (t * line.direction.xyz - x));
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
  vec4 plane = normals[face];
  vec3 normal = plane.xyz * orientation;
  if (inner(a, b, normal, x) && inner(b, c, normal, x) && inner(c, a, normal, x))
  {
    return SitePoint(face, (plane.w - dot(plane.xyz, x)) * plane.xyz);
  }
  // The bound of the face is dilated a little, so the point may belong to the border.
  ivec3 border = faceEdges[face].xyz;
  return nearer(closestOnEdge(border.x, x), nearer(closestOnEdge(border.y, x), closestOnEdge(border.z, x)));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 cell = pixel / sliceSize;
  int slot = cell.y * columns + cell.x;
  if (slot < firstSlot || slot >= endSlot)
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
