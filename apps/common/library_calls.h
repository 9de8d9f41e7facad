#pragma once

#include "progress_bar.h"

#include "medial/execution.h"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

namespace medial::app
{

/// Forwards progress to the terminal, and the user's request to stop to the library.
class Watch : public Progress
{
public:
  explicit Watch(ProgressBar& bar)
    : bar_(bar)
  {
  }

  void report(double fraction, const char* phase) override { bar_.show(fraction, phase); }
  bool cancelled() override;

private:
  ProgressBar& bar_;
};

/// The same for a step, whose progress is a part of that of all.
class PartWatch : public Watch
{
public:
  /// @param from where the step begins, in [0, 1]; it ends at `to`.
  /// @param phase shown in place of the library's.
  PartWatch(ProgressBar& bar, double from, double to, std::string phase)
    : Watch(bar)
    , from_(from)
    , to_(to)
    , phase_(std::move(phase))
  {
  }

  void report(double fraction, const char* phase) override;

private:
  double from_;
  double to_;
  std::string phase_;
};

///@{
/// Runs `work` and turns the library's errors into failures of the program.
/// @param input is named in front of the message; omit it for work whose errors name their files
///   themselves.
void withFailures(const std::filesystem::path& input, const std::function<void()>& work);
void withFailures(const std::function<void()>& work);
///@}

} // namespace medial::app
