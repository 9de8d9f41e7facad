#pragma once

#include "medial/execution.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace medial::test
{

/// Records reports of progress, which must ascend in [0, 1], and can cancel.
class RecordedProgress : public Progress
{
public:
  void report(double fraction, const char* /*phase*/) override
  {
    EXPECT_GE(fraction, this->last());
    EXPECT_LE(fraction, 1.0);
    fractions.push_back(fraction);
  }
  bool cancelled() override { return fractions.size() >= maxReports || this->last() >= cancelAt; }

  double last() const { return fractions.empty() ? 0.0 : fractions.back(); }

  std::vector<double> fractions;
  std::size_t maxReports = std::numeric_limits<std::size_t>::max(); ///< cancels after so many
  double cancelAt = 2.0;                                            ///< a fraction
};

} // namespace medial::test
