#include "thickness_policy.h"

#include "failure.h"

#include "medial/error.h"

#include <string>

namespace medial::app
{

double maxThicknessEdge(const Options& options, double diagonal)
{
  // Limits are to be kept inside large faces as well.
  constexpr Length kMaxEdge{ 2.0, true };
  const Length maxEdge =
    options.maxEdge.value_or(options.hasThicknessLimits() ? kMaxEdge : Length{});
  return maxEdge.value > 0.0 ? maxEdge.inUnits(diagonal) : 0.0;
}

void requireLimits(const ThicknessLimits& limits)
{
  try
  {
    checkThicknessLimits(limits);
  }
  catch (const Error& error)
  {
    throw Failure(ExitCode::Usage,
      std::string("--min-thickness, --max-thickness: ") + error.what());
  }
}

} // namespace medial::app
