#include "measure/sample_values.h"

#include "medial/axis_measurement.h"
#include "medial/error.h"

#include <string>

namespace medial
{

void checkSampleCount(std::int64_t samples)
{
  if (samples < kMinMeasureSamples || samples > kMaxMeasureSamples)
  {
    throw Error(ErrorCode::InvalidInput,
      "number of samples " + std::to_string(samples) + " is outside [" +
        std::to_string(kMinMeasureSamples) + ", " + std::to_string(kMaxMeasureSamples) + "]");
  }
}

} // namespace medial
