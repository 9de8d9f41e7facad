#include "field/engines/make_engine.h"

#include "field/engines/device/device_engine.h"
#include "field/engines/processor/processor_engine.h"
#include "field/engines/rasteriser/rasteriser_engine.h"

namespace medial
{
namespace
{

Engine resolved(Engine wanted)
{
  return wanted == Engine::Auto ? Engine::Processor : wanted;
}

} // namespace

std::unique_ptr<FieldEngine> makeEngine(Engine wanted)
{
  switch (resolved(wanted))
  {
    case Engine::Rasteriser:
      return std::make_unique<RasteriserEngine>();
    case Engine::Device:
      return std::make_unique<DeviceEngine>();
    case Engine::Auto:
    case Engine::Processor:
      break;
  }
  return std::make_unique<ProcessorEngine>();
}

FieldEngine& obtainEngine(Engine wanted, std::unique_ptr<FieldEngine>& kept)
{
  if (!kept || kept->kind() != resolved(wanted))
  {
    kept = makeEngine(wanted);
  }
  return *kept;
}

} // namespace medial
