#pragma once

#include "medial/export.h"

namespace medial
{

/// Receives progress and can cancel an operation. Long operations call both functions on the thread
/// that started them: for every slab, and also within long steps.
class MEDIAL_EXPORT Progress
{
public:
  virtual ~Progress() = default; ///< to be derived from

  /// Called with the progress so far.
  /// @param fraction share of the whole work that is done, in [0, 1], never decreasing.
  /// @param phase what is being done, a short lower-case text with static storage.
  virtual void report(double fraction, const char* phase) = 0;

  /// Returns true to stop the work. The operation then throws Error with ErrorCode::Cancelled.
  virtual bool cancelled() { return false; }
};

/// How an operation runs. It never changes a result.
struct Execution
{
  /// Number of CPU threads, >= 0; 0 for all cores. Never more than there are cores.
  int threads = 0;
  /// Receives progress and can cancel; may be null. Must outlive the operation.
  Progress* progress = nullptr;
};

} // namespace medial
