#include "base/run.h"

#include "base/range_check.h"
#include "medial/error.h"

#include <tbb/info.h>

#include <algorithm>
#include <string>

namespace medial
{
namespace
{

int threadsFor(const Execution& execution)
{
  if (execution.threads < 0)
  {
    throwOutside("threads", execution.threads, "[0, infinity)");
  }
  // TBB warns when it is asked for more threads than there are cores.
  const int cores = tbb::info::default_concurrency();
  return execution.threads > 0 ? std::min(execution.threads, cores) : cores;
}

} // namespace

Run::Run(const Execution& execution)
  : progress_(execution.progress)
  , threads_(threadsFor(execution))
{
}

Run Run::part(double begin, double end) const
{
  Run part = *this;
  part.begin_ = begin_ + (end_ - begin_) * begin;
  part.end_ = begin_ + (end_ - begin_) * end;
  return part;
}

void Run::report(double fraction, const char* phase) const
{
  if (progress_ == nullptr)
  {
    return;
  }
  progress_->report(begin_ + (end_ - begin_) * fraction, phase);
  if (progress_->cancelled())
  {
    throw Error(ErrorCode::Cancelled, "cancelled");
  }
}

} // namespace medial
