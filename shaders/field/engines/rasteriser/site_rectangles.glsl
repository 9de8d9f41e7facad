// The rectangles of a site in a layer of tiles: its reach, in parts of at most kLongest grid points a side, so that
// what is evaluated in them is precise.

layout(std430, binding = 0) readonly buffer Reaches { ivec4 reaches[]; }; // as gather_reaches.comp has them

const int kLongest = 64;

// How many parts there are along x and y.
ivec2 partsOf(ivec4 reach)
{
  return max((reach.zw - reach.xy + kLongest) / kLongest, ivec2(0));
}
