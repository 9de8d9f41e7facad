#include "measure/sample_values.h"

#include "medial/error.h"

#include <string>

namespace medial
{

void checkMeasureOptions(const MeasurementOptions& options)
{
  if (options.samples < kMinMeasureSamples || options.samples > kMaxMeasureSamples)
  {
    throw Error(ErrorCode::InvalidInput,
      "number of samples " + std::to_string(options.samples) + " is outside [" +
        std::to_string(kMinMeasureSamples) + ", " + std::to_string(kMaxMeasureSamples) + "]");
  }
}

} // namespace medial
