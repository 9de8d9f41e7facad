#include "medial/medial/evaluation/evaluation_steps.h"

#include <string>

namespace medial
{

void checkEvaluation(const EvaluationOptions& options)
{
  if (options.samples < kLeastEvaluationSamples || options.samples > kMostEvaluationSamples)
  {
    throw Error(ErrorCode::InvalidInput,
      "number of samples " + std::to_string(options.samples) + " is outside [" +
        std::to_string(kLeastEvaluationSamples) + ", " + std::to_string(kMostEvaluationSamples) +
        "]");
  }
  if (options.threads < 0)
  {
    throw Error(ErrorCode::InvalidInput,
      "threads " + std::to_string(options.threads) + " is negative");
  }
}

} // namespace medial
