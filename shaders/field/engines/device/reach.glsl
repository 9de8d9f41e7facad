// How far the closest points of the positions in a box can be, and which discs can hold them: as BoxReach. A work
// group of 64 does it together.
#include "grid.glsl"
#include "discs.glsl"

uniform float slack; // bound of the rounding of single precision

const int kCentre = 8; // after the corners
const float kFar = 1e30;
const float kRoundedUp = 1.0 + 1e-4; // squared distances times this are larger, however they are rounded

shared uint nearestSquared[9];  // of the corners and the centre, as bits
shared int nearestNodes[9];     // whose surface points are nearest to them
shared vec3 nearPoints[9];      // points of the surface near them
shared float cornerLimits[64];  // squared distances of the corners' surface points from all corners

float bestSquared[9];
int bestNodes[9];

void beginSearch()
{
  for (int i = 0; i < 9; ++i)
  {
    bestSquared[i] = kFar;
    bestNodes[i] = -1;
  }
  if (gl_LocalInvocationIndex < 9u)
  {
    nearestSquared[gl_LocalInvocationIndex] = floatBitsToUint(kFar);
    nearestNodes[gl_LocalInvocationIndex] = 0;
  }
}

void tryPoint(int i, float squared, int node)
{
  if (squared < bestSquared[i])
  {
    bestSquared[i] = squared;
    bestNodes[i] = node;
  }
}

// Tries the surface point of a node for all corners and the centre.
void tryNode(Box box, vec3 point, int node)
{
  vec3 v = box.centre - point;
  float squared = dot(v, v);
  tryPoint(kCentre, squared, node);
  vec3 t = 2.0 * box.halfSize * v;
  float middle = squared + dot(box.halfSize, box.halfSize);
  for (int corner = 0; corner < 8; ++corner)
  {
    tryPoint(corner, middle + dot(cornerSigns(corner), t), node);
  }
}

// Sets nearestNodes to the best of all invocations.
void endSearch()
{
  barrier();
  for (int i = 0; i < 9; ++i)
  {
    if (bestNodes[i] >= 0)
    {
      atomicMin(nearestSquared[i], floatBitsToUint(max(bestSquared[i], 0.0)));
    }
  }
  barrier();
  for (int i = 0; i < 9; ++i)
  {
    if (bestNodes[i] >= 0 && nearestSquared[i] == floatBitsToUint(max(bestSquared[i], 0.0)))
    {
      nearestNodes[i] = bestNodes[i];
    }
  }
  barrier();
}

// Squared distance from a position within which the closest points of the ball around it lie, by nearPoints.
float squaredReach(vec3 centre, float radius)
{
  float squared = kFar;
  for (int i = 0; i < 9; ++i)
  {
    vec3 v = nearPoints[i] - centre;
    squared = min(squared, dot(v, v));
  }
  float reach = sqrt(squared) + 2.0 * (radius + slack);
  return reach * reach * kRoundedUp;
}

// Sets cornerLimits by nearPoints.
void setCornerLimits(Box box)
{
  int point = int(gl_LocalInvocationIndex) >> 3;
  int corner = int(gl_LocalInvocationIndex) & 7;
  vec3 v = box.centre + cornerSigns(corner) * box.halfSize - nearPoints[point];
  cornerLimits[gl_LocalInvocationIndex] = dot(v, v) * kRoundedUp;
  barrier();
}

// Whether one of the points is nearer than the disc to all corners.
bool isDominated(Disc disc, Box box)
{
  uint dominating = 255u;
  for (int corner = 0; corner < 8 && dominating != 0u; ++corner)
  {
    vec2 place = placeOf(disc, box.centre + cornerSigns(corner) * box.halfSize);
    float squared = squaredDistance(disc, place);
    for (int point = 0; point < 8; ++point)
    {
      dominating &= squared > cornerLimits[8 * point + corner] ? 255u : ~(1u << point);
    }
  }
  return dominating != 0u;
}

bool meets(Disc disc, Box box, float radius, float reach)
{
  vec2 place = placeOf(disc, box.centre);
  return squaredDistance(disc, place) <= reach && meetsRegions(disc, place, radius) && !isDominated(disc, box);
}
