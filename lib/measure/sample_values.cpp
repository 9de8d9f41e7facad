#include "measure/sample_values.h"

#include "base/range_check.h"
#include "medial/axis_measurement.h"

namespace medial
{

void checkSampleCount(std::int64_t samples)
{
  if (samples < kMinMeasureSamples || samples > kMaxMeasureSamples)
  {
    throwOutside("number of samples", samples, closedRange(kMinMeasureSamples, kMaxMeasureSamples));
  }
}

} // namespace medial
