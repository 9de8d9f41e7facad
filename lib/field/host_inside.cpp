#include "field/host_inside.h"

#include "base/stopwatch.h"

namespace medial
{

HostInside::HostInside(const SignChoice& sign, const Extent& extent, const Run& run,
  RunStatistics& statistics)
  : sign_(sign)
  , extent_(extent)
  , run_(run)
  , statistics_(statistics)
{
}

const InsideRows& HostInside::rows() const
{
  if (!rows_)
  {
    const Stopwatch watch(statistics_.seconds.sign);
    run_.onThreads([&] { rows_ = sign_.insideRows(extent_); });
  }
  return *rows_;
}

} // namespace medial
