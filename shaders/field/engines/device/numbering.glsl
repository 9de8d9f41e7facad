// Dispatches have as many groups along y as they need, since x has few. A work group has 64 invocations, one for each item.

uint itemNumber()
{
  return gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * 64u;
}
