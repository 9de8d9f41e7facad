// Points of the surface near a box: of the elements of the groups whose surface points are nearest to its corners and
// its centre. Needs elements.glsl and reach.glsl.

shared uint writers[9]; // of nearPoints

Place placeAt(Element e, vec3 x)
{
  return placeOf(e, inPlane(e, x, vec3(0.0)));
}

// Returns the point of an element nearest to a position in its plane.
vec3 nearestPointOf(Element e, Place place, vec3 p)
{
  vec2 q = p.xy;
  if (place.offFace > 0.0)
  {
    vec3 past = max(max(place.before, place.beyond), vec3(0.0));
    vec3 squared = past * past + place.outside * place.outside;
    vec3 t = clamp(vec3(p.x, dot(p.xy, e.directions.xy), dot(p.xy, e.directions.zw)), e.starts, e.ends);
    if (squared.x <= squared.y && squared.x <= squared.z)
    {
      q = vec2(t.x, e.offsets.x);
    }
    else if (squared.y <= squared.z)
    {
      q = t.y * e.directions.xy - e.offsets.y * vec2(e.directions.y, -e.directions.x);
    }
    else
    {
      q = t.z * e.directions.zw - e.offsets.z * vec2(-e.directions.w, e.directions.z);
    }
  }
  return e.origin + (q.x * e.along + q.y * e.across);
}

// Sets nearPoints[i] to the point nearest to a position of an element of a group; eight invocations do it together.
void searchGroup(int i, vec3 x, bool takesPart)
{
  float squared = kFar;
  vec3 point;
  if (takesPart)
  {
    Element e = loadElement(8 * nearestNodes[i] + int(gl_LocalInvocationIndex & 7u));
    if (exists(e))
    {
      vec3 p = inPlane(e, x, vec3(0.0));
      Place place = placeOf(e, p);
      squared = place.squared;
      point = nearestPointOf(e, place, p);
      atomicMin(nearestSquared[i], floatBitsToUint(squared));
    }
  }
  barrier();
  // Of several at the same distance one alone may write: a mixture of their points is none of the surface.
  if (takesPart && squared < kFar && floatBitsToUint(squared) == nearestSquared[i])
  {
    atomicMin(writers[i], gl_LocalInvocationIndex);
  }
  barrier();
  if (takesPart && writers[i] == gl_LocalInvocationIndex)
  {
    nearPoints[i] = point;
  }
  barrier();
}

// Sets nearPoints after endSearch().
void searchElements(Box box)
{
  uint me = gl_LocalInvocationIndex;
  if (me < 9u)
  {
    nearestSquared[me] = floatBitsToUint(kFar);
    writers[me] = 64u;
    nearPoints[me] = loadDisc(nearestNodes[me]).surfacePoint;
  }
  barrier();
  int corner = int(me) >> 3;
  searchGroup(corner, box.centre + cornerSigns(corner) * box.halfSize, true);
  searchGroup(kCentre, box.centre, me < 8u);
}
