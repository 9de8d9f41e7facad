#pragma once

#include <chrono>
#include <string>

namespace medial::app
{

/// One line on standard error that says what is being done and how far it has got; silent unless
/// standard error is a terminal.
class ProgressBar
{
public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @param fraction share of the whole work that is done, in [0, 1].
  /// @param phase what is being done, a short lower-case text.
  void show(double fraction, const char* phase);

  /// Removes the line, so that other text can be printed.
  void clear();

private:
  bool visible_ = false;
  std::string phase_; // of the line that is shown; empty for none
  std::chrono::steady_clock::time_point lastDrawn_;
};

} // namespace medial::app
