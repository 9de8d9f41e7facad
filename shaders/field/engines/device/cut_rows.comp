#version 450 core
// Where the rows of a slab, and of the slice below it, pass through faces, and how the winding number changes there:
// as addCrossings(). What rounding leaves in doubt is listed instead, for the host, which has the exact positions.
// One work group does a face.
//
// in   weights  how often each face counts
// out  changes  of the winding number, from one grid point of a row to the next
//      doubts   their number; then, by threes: face, slice, row
#include "mesh.glsl"
#include "rows.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer Weights { int weights[]; };
layout(std430, binding = 3) buffer Changes { int changes[]; };
layout(std430, binding = 4) buffer Doubts { uint doubtCount; int doubts[]; };

uniform dvec3 rowFirst; // where grid point (0,0,0) is taken to be
uniform dvec3 exactSpacing;
uniform ivec3 slabMin;
uniform int firstSlice; // the one below the slab, where there is one
uniform double doubt;   // bound of the errors of positions, here and on the host
uniform int room;       // for doubts

// The planes between two coordinates, and one more on either side, as far as they are in [least, most].
ivec2 planesBetween(double low, double high, double origin, double spacing, int least, int most)
{
  dvec2 at = clamp((dvec2(low, high) - origin) / spacing, double(least) - 2.0LF, double(most) + 2.0LF);
  return ivec2(max(least, int(floor(at.x))), min(most, int(ceil(at.y))));
}

// The crossing of an edge with the plane of a slice; z: bound of its errors.
dvec3 crossPlane(dvec3 low, dvec3 high, double z)
{
  dvec2 along = high.xy - low.xy;
  double height = high.z - low.z;
  double slope = max(abs(along.x), abs(along.y)) / height;
  return dvec3(low.xy + (z - low.z) / height * along, doubt * (1.0LF + slope));
}

// Adds the change where a row passes through the triangle. Returns whether there was no doubt.
bool cutRow(dvec3 corners[3], int weight, int slice, int row)
{
  double y = rowFirst.y + double(row) * exactSpacing.y;
  double z = rowFirst.z + double(slice) * exactSpacing.z;
  dvec3 from = dvec3(0.0LF);
  dvec3 to = dvec3(0.0LF);
  bool isCut = false;
  bool isClear = true;
  for (int i = 0; i < 3; ++i)
  {
    dvec3 p = corners[i];
    dvec3 q = corners[(i + 1) % 3];
    isClear = isClear && abs(p.z - z) > doubt;
    bool below = p.z < z;
    if (below != (q.z < z))
    {
      dvec3 crossing = below ? crossPlane(p, q, z) : crossPlane(q, p, z);
      from = below ? crossing : from;
      to = below ? to : crossing;
      isCut = true;
    }
  }
  if (!isClear || !isCut)
  {
    return isClear;
  }
  if (abs(from.y - y) <= from.z || abs(to.y - y) <= to.z)
  {
    return false;
  }
  bool enters = from.y < y;
  if (enters == (to.y < y))
  {
    return true;
  }
  dvec2 along = to.xy - from.xy;
  double index = (from.x + (y - from.y) / along.y * along.x - rowFirst.x) / exactSpacing.x;
  double error = max(from.z, to.z) * (1.0LF + abs(along.x / along.y)) / exactSpacing.x;
  int last = slabMin.x + slabSize.x - 1;
  if (index - error >= double(last) || index + error < double(slabMin.x) - 1.0LF)
  {
    index = clamp(index, double(slabMin.x) - 0.5LF, double(last) + 0.5LF); // in no doubt
  }
  else if (abs(index - round(index)) <= error)
  {
    return false;
  }
  if (index < double(last))
  {
    int x = max(int(floor(index)) + 1 - slabMin.x, 0);
    int at = ((slice - slabMin.z + 1) * slabSize.y + row - slabMin.y) * slabSize.x + x;
    atomicAdd(changes[at], enters ? weight : -weight);
  }
  return true;
}

void main()
{
  int face = int(gl_WorkGroupID.x + gl_WorkGroupID.y * gl_NumWorkGroups.x);
  if (face >= faceCount || weights[face] == 0)
  {
    return;
  }
  ivec3 ids = faceCorners(face);
  dvec3 corners[3] = dvec3[3](pointAt(ids.x), pointAt(ids.y), pointAt(ids.z));
  dvec3 low = min(corners[0], min(corners[1], corners[2]));
  dvec3 high = max(corners[0], max(corners[1], corners[2]));
  ivec2 slices =
    planesBetween(low.z, high.z, rowFirst.z, exactSpacing.z, firstSlice, slabMin.z + slots - 2);
  ivec2 rows =
    planesBetween(low.y, high.y, rowFirst.y, exactSpacing.y, slabMin.y, slabMin.y + slabSize.y - 1);
  int rowCount = max(rows.y - rows.x + 1, 0);
  int count = max(slices.y - slices.x + 1, 0) * rowCount;
  for (int i = int(gl_LocalInvocationIndex); i < count; i += 64)
  {
    int slice = slices.x + i / rowCount;
    int row = rows.x + i % rowCount;
    if (!cutRow(corners, weights[face], slice, row))
    {
      uint at = atomicAdd(doubtCount, 1u);
      if (at < uint(room))
      {
        doubts[3u * at] = face;
        doubts[3u * at + 1u] = slice;
        doubts[3u * at + 2u] = row;
      }
    }
  }
}
