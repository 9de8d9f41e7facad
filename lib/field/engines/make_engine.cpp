#include "field/engines/make_engine.h"

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

std::unique_ptr<FieldEngine> makeEngine(Engine wanted, const std::string& device)
{
  if (resolved(wanted) == Engine::Rasteriser)
  {
    return std::make_unique<RasteriserEngine>(device);
  }
  return std::make_unique<ProcessorEngine>();
}

FieldEngine& obtainEngine(Engine wanted, const std::string& device,
  std::unique_ptr<FieldEngine>& kept)
{
  if (!kept || kept->kind() != resolved(wanted))
  {
    kept = makeEngine(wanted, device);
  }
  return *kept;
}

} // namespace medial
