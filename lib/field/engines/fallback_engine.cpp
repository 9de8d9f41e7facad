#include "field/engines/fallback_engine.h"

#include "field/engines/processor/processor_engine.h"
#include "field/engines/resumed_sink.h"
#include "gl/context_lost.h"
#include "medial/error.h"

#include <utility>

namespace medial
{
namespace
{

/// Whether a device that has failed so may do another job.
bool isOfTheJob(const Error& error)
{
  return error.code() == ErrorCode::GpuLimit ||
    error.code() == ErrorCode::InvalidInput; // too far from the mesh for single precision
}

/// Whether the processor may do what a device could not.
bool isOfTheDevice(const Error& error)
{
  return isOfTheJob(error) || error.code() == ErrorCode::NoGpu ||
    error.code() == ErrorCode::ShaderBuild || error.code() == ErrorCode::OutOfMemory;
}

bool isReset(const Error& error)
{
  return dynamic_cast<const gl::ContextLost*>(&error) != nullptr;
}

std::string firstLine(const std::string& text)
{
  return text.substr(0, text.find('\n'));
}

} // namespace

double workOf(const FieldJob& job)
{
  // Of an H100's host; an estimate within a factor of two for meshes of 20,000 to a million
  // triangles and resolutions of 64 to 1024 (docs/design/device-engine.md).
  constexpr double kSecondsOfPoint = 25e-9;
  constexpr double kSecondsOfTriangle = 1e-5;
  return kSecondsOfPoint * static_cast<double>(job.extent.pointCount()) +
    kSecondsOfTriangle * static_cast<double>(job.mesh.triangles.size());
}

FallbackEngine::FallbackEngine(Make make, double patience)
  : make_(std::move(make))
  , patience_(patience)
  , renews_(patience > 0.0)
  , second_(std::make_unique<ProcessorEngine>())
{
  if (!renews_)
  {
    this->makeFirst();
  }
}

void FallbackEngine::makeFirst()
{
  try
  {
    first_ = make_();
  }
  catch (const Error& error)
  {
    this->note(error);
  }
}

/// Once patience has run out; and after a reset, which leaves a device as good as new.
void FallbackEngine::renewFirst(RunStatistics& statistics)
{
  if (patience_ > 0.0 || !std::exchange(renews_, false))
  {
    return;
  }
  this->makeFirst();
  if (first_)
  {
    statistics.engine = first_->kind();
    statistics.device = first_->device();
  }
}

void FallbackEngine::note(const Error& error)
{
  const std::string why = error.what();
  failure_ = "the engine device failed (" + firstLine(why) + "), so the processor did the work";
}

Engine FallbackEngine::kind() const
{
  return first_ ? first_->kind() : second_->kind();
}

std::optional<Device> FallbackEngine::device() const
{
  return first_ ? first_->device() : second_->device();
}

template <typename Work>
auto FallbackEngine::attempt(const FieldJob& job, FieldSink& sink, const Work& work)
{
  ResumedSink resumed(job.extent, sink);
  patience_ -= workOf(job);
  this->renewFirst(job.statistics);
  if (first_)
  {
    try
    {
      return work(*first_, resumed);
    }
    catch (const Error& error)
    {
      if (resumed.failed() || !isOfTheDevice(error))
      {
        throw;
      }
      this->note(error);
      if (!isOfTheJob(error))
      {
        first_.reset();
        renews_ = isReset(error) && resets_++ == 0;
      }
    }
  }
  job.statistics.engine = second_->kind();
  job.statistics.device.reset();
  job.statistics.note = failure_;
  return work(*second_, resumed);
}

void FallbackEngine::run(const FieldJob& job, FieldSink& sink)
{
  this->attempt(job, sink,
    [&](FieldEngine& engine, FieldSink& to)
    {
      engine.run(job, to);
      return true;
    });
}

std::vector<Crossing> FallbackEngine::select(const FieldJob& job,
  const CrossingSelection& selection, FieldSink& sink)
{
  return this->attempt(job, sink,
    [&](FieldEngine& engine, FieldSink& to) { return engine.select(job, selection, to); });
}

} // namespace medial
