#include "field/engines/make_engine.h"

#include "field/engines/device/device_engine.h"
#include "field/engines/fallback_engine.h"
#include "field/engines/processor/processor_engine.h"
#include "field/engines/rasteriser/rasteriser_engine.h"
#include "gl/egl_context.h"
#include "gl/gpu_thread.h"
#include "medial/error.h"

namespace medial
{
namespace
{

/// What the processor does before a device is started, in seconds of one core: a second of four.
/// Starting takes 0.1 s, and 2 s where the driver has yet to compile the shaders.
constexpr double kPatience = 4.0;

/// Whether OpenGL runs on graphics hardware.
bool runsOnHardware(const std::string& device)
{
  return !gl::GpuThread::instance(device).device().software;
}

/// Whether nobody waits for a device to be started, which takes longer than a small field.
bool isPatient(const DistanceFieldOptions& options)
{
  return options.device.empty() && !options.requireHardware;
}

/// Whether there may be a device that is worth having. Where one was asked for that is missing,
/// FallbackEngine says why.
bool mayHaveDevice(const DistanceFieldOptions& options)
{
  if (isPatient(options))
  {
    return gl::mayHaveHardware();
  }
  try
  {
    return runsOnHardware(options.device);
  }
  catch (const Error&)
  {
    return true;
  }
}

/// Returns Auto only where there is a choice.
Engine resolved(const DistanceFieldOptions& options)
{
  return options.engine == Engine::Auto && !mayHaveDevice(options) ? Engine::Processor
                                                                   : options.engine;
}

std::unique_ptr<FieldEngine> makeHardware(const std::string& device)
{
  return runsOnHardware(device) ? std::make_unique<DeviceEngine>(device) : nullptr;
}

} // namespace

std::unique_ptr<FieldEngine> makeEngine(const DistanceFieldOptions& options)
{
  const std::string& device = options.device;
  switch (resolved(options))
  {
    case Engine::Auto:
      return std::make_unique<FallbackEngine>([=] { return makeHardware(device); },
        isPatient(options) ? kPatience : 0.0);
    case Engine::Rasteriser:
      return std::make_unique<RasteriserEngine>(device);
    case Engine::Device:
      return std::make_unique<DeviceEngine>(device);
    case Engine::Processor:
      break;
  }
  return std::make_unique<ProcessorEngine>();
}

FieldEngine& obtainEngine(const DistanceFieldOptions& options, std::unique_ptr<FieldEngine>& kept)
{
  // Where it may serve anyway, nobody looks for hardware again.
  if (!kept || !(kept->serves(options.engine) || kept->serves(resolved(options))))
  {
    kept = makeEngine(options);
  }
  return *kept;
}

} // namespace medial
