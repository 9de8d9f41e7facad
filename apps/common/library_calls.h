#pragma once

#include "progress_bar.h"

#include "medial/execution.h"

#include <filesystem>
#include <functional>

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

///@{
/// Runs `work` and turns the library's errors into failures of the program.
/// @param input is named in front of the message; omit it for work whose errors name their files
///   themselves.
void withFailures(const std::filesystem::path& input, const std::function<void()>& work);
void withFailures(const std::function<void()>& work);
///@}

} // namespace medial::app
