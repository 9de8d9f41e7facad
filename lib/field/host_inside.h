#pragma once

#include "base/run.h"
#include "medial/grid.h"
#include "medial/run_statistics.h"
#include "sign/inside_rows.h"
#include "sign/sign_choice.h"

#include <optional>

namespace medial
{

/// Which grid points of a job are inside, where winding numbers tell. The rows in host memory are
/// made when they are first asked for, which is for one thread: an engine on a device may need
/// none.
class HostInside
{
public:
  /// @param sign its method is Winding. It and the statistics, which get the seconds, must outlive
  ///   this.
  HostInside(const SignChoice& sign, const Extent& extent, const Run& run,
    RunStatistics& statistics);

  const InsideRows& rows() const;
  const SignChoice& sign() const { return sign_; }

private:
  const SignChoice& sign_;
  Extent extent_;
  Run run_;
  RunStatistics& statistics_;
  mutable std::optional<InsideRows> rows_;
};

} // namespace medial
