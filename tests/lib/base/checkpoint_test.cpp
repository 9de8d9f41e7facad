#include "base/checkpoint.h"

#include "medial/compute_medial_axis.h"
#include "medial/error.h"
#include "medial/execution.h"
#include "support/errors.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace
{

using namespace std::chrono_literals;

class Recorder : public medial::Progress
{
public:
  void report(double fraction, const char* phase) override
  {
    fractions.push_back(fraction);
    phases.emplace_back(phase);
  }
  bool cancelled() override { return cancel; }

  std::vector<double> fractions;
  std::vector<std::string> phases;
  bool cancel = false;
};

/// Calls a checkpoint for some time, as a loop over small parts does.
void callFor(std::chrono::milliseconds duration, const medial::Checkpoint& checkpoint)
{
  const auto end = std::chrono::steady_clock::now() + duration;
  while (std::chrono::steady_clock::now() < end)
  {
    checkpoint();
  }
}

TEST(Checkpoint, ReportsNowAndThen)
{
  Recorder recorder;
  const medial::Checkpoint checkpoint(medial::Run({ 0, &recorder }), 0.25, "thinking");
  // A busy machine may let it wait.
  for (int i = 0; i < 50 && recorder.fractions.size() < 2; ++i)
  {
    callFor(200ms, checkpoint);
  }
  EXPECT_GE(recorder.fractions.size(), 2U);
  EXPECT_LE(recorder.fractions.size(), 10U);
  EXPECT_EQ(recorder.fractions[0], 0.25);
  EXPECT_EQ(recorder.phases[0], "thinking");
}

TEST(Checkpoint, ThrowsWhenCancelled)
{
  Recorder recorder;
  recorder.cancel = true;
  const medial::Checkpoint checkpoint(medial::Run({ 0, &recorder }), 0.5, "thinking");
  medial::test::expectError([&] { callFor(10s, checkpoint); }, medial::ErrorCode::Cancelled);
}

TEST(Checkpoint, OtherThreadsAreNotDisturbed)
{
  Recorder recorder;
  recorder.cancel = true;
  const medial::Checkpoint checkpoint(medial::Run({ 0, &recorder }), 0.5, "thinking");
  std::thread other([&] { callFor(100ms, checkpoint); });
  other.join();
  EXPECT_TRUE(recorder.fractions.empty());
}

TEST(Checkpoint, NeedsNoProgress)
{
  const medial::Checkpoint checkpoint(medial::Run({ 0, nullptr }), 0.5, "thinking");
  EXPECT_NO_THROW(callFor(50ms, checkpoint));
}

/// Cancels a while after the field is done.
class LateCancel : public medial::Progress
{
public:
  void report(double fraction, const char* phase) override
  {
    reports_ += std::string(phase) == "medial axis" && fraction < 1.0 ? 1 : 0;
  }
  bool cancelled() override { return reports_ >= 3; }

private:
  int reports_ = 0;
};

TEST(Checkpoint, ThinningCanBeCancelled)
{
  const medial::TriangleMesh mesh = medial::test::icosphere(1.0, 3);
  LateCancel progress;
  medial::MedialAxisOptions options;
  options.topology = medial::Topology::Preserve;
  options.field.execution.progress = &progress;
  EXPECT_THROW(medial::computeMedialAxis(mesh, medial::makeGrid(mesh.bounds(), 256), options),
    medial::Error);
}

} // namespace
