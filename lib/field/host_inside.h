#pragma once

#include "base/run.h"
#include "medial/grid.h"
#include "medial/run_statistics.h"
#include "sign/inside_rows.h"
#include "sign/sign_choice.h"

#include <optional>
#include <utility>

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

  /// Has rows that are made already, for engines without a device.
  explicit HostInside(InsideRows rows)
    : rows_(std::move(rows))
  {
  }

  const InsideRows& rows() const;
  /// What the rows are made by. Only where they were not made already.
  const SignChoice& sign() const { return maker_->sign; }

private:
  /// What rows are made of.
  struct Maker
  {
    const SignChoice& sign;
    Extent extent;
    Run run;
    RunStatistics& statistics;
  };

  std::optional<Maker> maker_;
  mutable std::optional<InsideRows> rows_;
};

} // namespace medial
