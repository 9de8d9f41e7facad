// What the kernels count in a slab.

layout(std430, binding = 4) buffer Counters
{
  uint listLength;  // nodes in all lists; beyond their room where it did not suffice
  uint tests;       // pairs of a node and a box
  uint pairs;       // pairs of an element and a tile that were left
  uint evaluations; // pairs of an element and a block of 2 x 2 x 2 grid points
  uint withoutSite; // grid points for which no element was left
  uint listed;      // crossings of a slab, or rectangles of a layer
};
