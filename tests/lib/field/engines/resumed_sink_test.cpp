#include "field/engines/resumed_sink.h"

#include "field/slabs.h"
#include "support/collecting_sink.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace medial::test
{
namespace
{

const Extent kExtent{ { 2, 3, 5 }, { 4, 4, 41 } };

std::size_t sliceSize()
{
  return static_cast<std::size_t>(kExtent.size(0)) * kExtent.size(1);
}

/// Writes the number of its slice to every point of a slab.
void fill(const Extent& slab, const FieldArrays& arrays)
{
  for (std::size_t i = 0; i < sliceSize() * slab.size(2); ++i)
  {
    const int slice = slab.min[2] + static_cast<int>(i / sliceSize());
    arrays.distance[i] = static_cast<float>(slice);
    arrays.closestSite[i] = 2 * slice;
  }
}

/// Stores some slabs, and leaves the next one open if there is one.
void storeSome(FieldSink& sink, const std::vector<Extent>& slabs, std::size_t count)
{
  for (std::size_t i = 0; i < slabs.size() && i <= count; ++i)
  {
    const FieldArrays arrays = sink.slabArrays(slabs[i]);
    if (i < count)
    {
      fill(slabs[i], arrays);
      sink.stored(slabs[i]);
    }
  }
}

TEST(ResumedSink, PassesEverySliceOnceHoweverBothEnginesCut)
{
  for (const int first : { 1, 2, 8, 64 })
  {
    for (const int second : { 1, 4, 16, 64 })
    {
      for (const std::size_t stored : { 0u, 1u, 3u })
      {
        CollectingSink sink(kExtent, 8);
        ResumedSink resumed(kExtent, sink);
        const std::vector<Extent> slabs = slabsOf(kExtent, first);
        if (stored >= slabs.size())
        {
          continue;
        }
        storeSome(resumed, slabs, stored);
        const std::vector<Extent> all = slabsOf(kExtent, second);
        storeSome(resumed, all, all.size());
        ASSERT_EQ(sink.distance.size(), static_cast<std::size_t>(kExtent.pointCount()));
        for (std::size_t i = 0; i < sink.distance.size(); ++i)
        {
          const int slice = kExtent.min[2] + static_cast<int>(i / sliceSize());
          ASSERT_EQ(sink.distance[i], static_cast<float>(slice));
          ASSERT_EQ(sink.site[i], 2 * slice);
        }
      }
    }
  }
}

} // namespace
} // namespace medial::test
