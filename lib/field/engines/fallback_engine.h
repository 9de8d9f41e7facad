#pragma once

#include "field/field_engine.h"
#include "medial/error.h"

#include <functional>
#include <memory>
#include <string>

namespace medial
{

/// The engine `auto` where there is graphics hardware: the processor until its jobs add up to more
/// work than starting a device is worth, then the device, and the processor again as soon as the
/// device fails. What the device has stored by then stays, the processor goes on, and a note in the
/// statistics says why. A job that is too much for the device leaves it the next one, and so does a
/// reset of the device, once.
class FallbackEngine : public FieldEngine
{
public:
  using Make = std::function<std::unique_ptr<FieldEngine>()>;

  /// @param make makes the device. It may throw, which counts as a failure, and may return null if
  ///   there is none worth having.
  /// @param patience work after which it is made: estimated seconds of one core; see workOf(). It
  ///   counts no real time, so that the same jobs always get the same engines.
  explicit FallbackEngine(Make make, double patience = 0.0);

  Engine kind() const override;
  bool serves(Engine wanted) const override { return wanted == Engine::Auto; }
  std::optional<Device> device() const override;

  void run(const FieldJob& job, FieldSink& sink) override;
  std::vector<Crossing> select(const FieldJob& job, const CrossingSelection& selection,
    FieldSink& sink) override;

private:
  template <typename Work>
  auto attempt(const FieldJob& job, FieldSink& sink, const Work& work);
  void makeFirst();
  void renewFirst(RunStatistics& statistics);
  void note(const Error& error);

  Make make_;
  std::unique_ptr<FieldEngine> first_; ///< null once it has failed
  double patience_;                    ///< what is left of it
  bool renews_ = false;                ///< whether the next job makes it (again)
  int resets_ = 0;
  std::unique_ptr<FieldEngine> second_;
  std::string failure_; ///< the last one
};

/// Estimates how long a core takes for a field, in seconds.
double workOf(const FieldJob& job);

} // namespace medial
