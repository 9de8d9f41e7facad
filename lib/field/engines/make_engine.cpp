#include "field/engines/make_engine.h"

#include "field/engines/device/device_engine.h"
#include "field/engines/fallback_engine.h"
#include "field/engines/processor/processor_engine.h"
#include "field/engines/rasteriser/rasteriser_engine.h"
#include "gl/egl_context.h"
#include "medial/device.h"
#include "medial/error.h"

namespace medial
{
namespace
{

/// Whether OpenGL runs on graphics hardware.
bool hasHardware()
{
  try
  {
    return gl::mayHaveHardware() && !queryDevice().software;
  }
  catch (const Error&)
  {
    return false;
  }
}

/// Returns Auto only where there is a choice.
Engine resolved(Engine wanted)
{
  return wanted == Engine::Auto && !hasHardware() ? Engine::Processor : wanted;
}

} // namespace

std::unique_ptr<FieldEngine> makeEngine(Engine wanted)
{
  switch (resolved(wanted))
  {
    case Engine::Auto:
      return std::make_unique<FallbackEngine>([] { return std::make_unique<DeviceEngine>(); });
    case Engine::Rasteriser:
      return std::make_unique<RasteriserEngine>();
    case Engine::Device:
      return std::make_unique<DeviceEngine>();
    case Engine::Processor:
      break;
  }
  return std::make_unique<ProcessorEngine>();
}

FieldEngine& obtainEngine(Engine wanted, std::unique_ptr<FieldEngine>& kept)
{
  if (!kept || !kept->serves(resolved(wanted)))
  {
    kept = makeEngine(wanted);
  }
  return *kept;
}

} // namespace medial
