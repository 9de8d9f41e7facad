#include "field/engines/fallback_engine.h"

#include "field/engines/processor/processor_engine.h"
#include "field/engines/resumed_sink.h"
#include "medial/error.h"

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

std::string firstLine(const std::string& text)
{
  return text.substr(0, text.find('\n'));
}

} // namespace

FallbackEngine::FallbackEngine(const Make& make)
  : second_(std::make_unique<ProcessorEngine>())
{
  try
  {
    first_ = make();
  }
  catch (const Error& error)
  {
    this->note(error);
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
