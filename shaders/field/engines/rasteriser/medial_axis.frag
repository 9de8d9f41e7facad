#version 450 core
// Selection by separation angle (Foskey, Lin, Manocha 2003): which grid edges from a point to its
// +x, +y and +z neighbours the simplified medial axis crosses.
//
// in   direction  RGBA32F atlas; xyz: unit vector to the closest point, w: signed distance
// out  crossings  R8UI; bits 0, 1, 2: the edge along x, y, z is crossed; bit 3: any is, and inside

uniform sampler2D direction;
uniform ivec2 sliceSize;   // grid points of a slice
uniform int columns;       // slots of the atlas in a row
uniform int firstSlot;     // 0 where slot 0 holds the slice before the slab, else 1
uniform int endSlot;       // one past the last slot in use
uniform vec3 spacing;      // distance of neighbouring grid points, local units
uniform float cosineLimit; // cosine of the minimum separation angle
uniform float side;        // -1: interior, 1: exterior, 0: both

layout(location = 0) out uint crossings;

bool wanted(float distance)
{
  return side == 0.0 || distance * side > 0.0;
}

// near: at this point; far: at the neighbour, `edge` away
bool crossed(vec4 near, vec4 far, vec3 edge)
{
  bool sameSide = near.w * far.w > 0.0 && wanted(near.w);
  bool apart = dot(near.xyz, far.xyz) <= cosineLimit;
  // If the closest points are nearer to each other than the grid points, both see the same reflex
  // edge or the same patch, not two sides.
  vec3 gap = edge + far.xyz * abs(far.w) - near.xyz * abs(near.w);
  return sameSide && apart && dot(gap, gap) >= dot(edge, edge);
}

ivec2 slotOrigin(int slot)
{
  return ivec2(slot % columns, slot / columns) * sliceSize;
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 cell = pixel / sliceSize;
  int slot = cell.y * columns + cell.x;
  crossings = 0u;
  if (slot < firstSlot || slot >= endSlot)
  {
    return;
  }
  ivec2 point = pixel - cell * sliceSize;
  vec4 near = texelFetch(direction, pixel, 0);
  // The slice in slot 0 was compared along x and y when it was part of its own slab.
  if (slot > 0 && point.x + 1 < sliceSize.x)
  {
    vec4 far = texelFetch(direction, pixel + ivec2(1, 0), 0);
    crossings |= crossed(near, far, vec3(spacing.x, 0.0, 0.0)) ? 1u : 0u;
  }
  if (slot > 0 && point.y + 1 < sliceSize.y)
  {
    vec4 far = texelFetch(direction, pixel + ivec2(0, 1), 0);
    crossings |= crossed(near, far, vec3(0.0, spacing.y, 0.0)) ? 2u : 0u;
  }
  if (slot + 1 < endSlot)
  {
    vec4 far = texelFetch(direction, slotOrigin(slot + 1) + point, 0);
    crossings |= crossed(near, far, vec3(0.0, 0.0, spacing.z)) ? 4u : 0u;
  }
  if (crossings != 0u && near.w < 0.0)
  {
    crossings |= 8u;
  }
}
