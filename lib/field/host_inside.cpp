#include "field/host_inside.h"

#include "base/stopwatch.h"

namespace medial
{

HostInside::HostInside(const SignChoice& sign, const Extent& extent, const Run& run,
  RunStatistics& statistics)
  : maker_(Maker{ sign, extent, run, statistics })
{
}

const InsideRows& HostInside::rows() const
{
  if (!rows_)
  {
    const Stopwatch watch(maker_->statistics.seconds.sign);
    maker_->run.onThreads([&] { rows_ = maker_->sign.insideRows(maker_->extent); });
  }
  return *rows_;
}

} // namespace medial
