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

/// Whether OpenGL runs on graphics hardware, or fails where there may be some or where a device was
/// asked for: FallbackEngine then says why.
bool hasHardware(const std::string& device)
{
  if (device.empty() && !gl::mayHaveHardware())
  {
    return false;
  }
  try
  {
    return !gl::GpuThread::instance(device).device().software;
  }
  catch (const Error&)
  {
    return true;
  }
}

/// Returns Auto only where there is a choice.
Engine resolved(Engine wanted, const std::string& device)
{
  return wanted == Engine::Auto && !hasHardware(device) ? Engine::Processor : wanted;
}

} // namespace

std::unique_ptr<FieldEngine> makeEngine(Engine wanted, const std::string& device)
{
  switch (resolved(wanted, device))
  {
    case Engine::Auto:
      return std::make_unique<FallbackEngine>(
        [=] { return std::make_unique<DeviceEngine>(device); });
    case Engine::Rasteriser:
      return std::make_unique<RasteriserEngine>(device);
    case Engine::Device:
      return std::make_unique<DeviceEngine>(device);
    case Engine::Processor:
      break;
  }
  return std::make_unique<ProcessorEngine>();
}

FieldEngine& obtainEngine(Engine wanted, const std::string& device,
  std::unique_ptr<FieldEngine>& kept)
{
  // Where it may serve anyway, nobody looks for hardware again.
  if (!kept || !(kept->serves(wanted) || kept->serves(resolved(wanted, device))))
  {
    kept = makeEngine(wanted, device);
  }
  return *kept;
}

} // namespace medial
