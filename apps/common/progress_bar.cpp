#include "progress_bar.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace medial::app
{
namespace
{

constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kRedrawInterval{ 50 };

} // namespace

ProgressBar::ProgressBar(bool quiet)
  : visible_(!quiet && isatty(STDERR_FILENO) == 1)
{
}

ProgressBar::~ProgressBar()
{
  clear();
}

void ProgressBar::show(double fraction, const char* phase)
{
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || (phase_ == phase && now - lastDrawn_ < kRedrawInterval))
  {
    return;
  }
  const double share = std::clamp(fraction, 0.0, 1.0);
  const int filled = static_cast<int>(share * kWidth);
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r[%s] %3d%% %s\033[K", bar.c_str(), static_cast<int>(100 * share), phase);
  std::fflush(stderr);
  phase_ = phase;
  lastDrawn_ = now;
}

void ProgressBar::clear()
{
  if (!phase_.empty())
  {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    phase_.clear();
  }
}

} // namespace medial::app
