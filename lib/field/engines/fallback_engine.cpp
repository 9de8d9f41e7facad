#include "field/engines/fallback_engine.h"

#include "field/engines/processor/processor_engine.h"
#include "field/engines/resumed_sink.h"
#include "medial/error.h"

namespace medial
{
namespace
{

/// Whether the processor may do what a device could not.
bool isOfTheDevice(const Error& error)
{
  switch (error.code())
  {
    case ErrorCode::NoGpu:
    case ErrorCode::ShaderBuild:
    case ErrorCode::GpuLimit:
    case ErrorCode::OutOfMemory:
    case ErrorCode::InvalidInput: // too far from the mesh for single precision
      return true;
    case ErrorCode::CannotRead:
    case ErrorCode::CannotWrite:
    case ErrorCode::Cancelled:
      break;
  }
  return false;
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
    this->giveUp(error.what());
  }
}

void FallbackEngine::giveUp(const std::string& why)
{
  first_.reset();
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
      if (!isOfTheDevice(error))
      {
        throw;
      }
      this->giveUp(error.what());
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
