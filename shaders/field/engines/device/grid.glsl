// The grid points of a slab, in local coordinates.

uniform ivec3 slabMin;
uniform ivec3 slabMax; // included
uniform vec3 first;    // grid point (0,0,0)
uniform vec3 spacing;

// An axis-aligned box, by its centre and half its lengths.
struct Box
{
  vec3 centre;
  vec3 halfSize;
};

// The hull of grid points.
Box hullOf(ivec3 low, ivec3 high)
{
  return Box(first + 0.5 * vec3(low + high) * spacing, 0.5 * vec3(high - low) * spacing);
}

// 1 or -1 per axis
vec3 cornerSigns(int corner)
{
  return vec3((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0);
}

// Number of a grid point of the slab.
int pointNumber(ivec3 point)
{
  ivec3 size = slabMax - slabMin + 1;
  ivec3 at = point - slabMin;
  return (at.z * size.y + at.y) * size.x + at.x;
}
