#include "option_names.h"

#include <algorithm>

namespace medial::app
{
namespace
{

template <typename T>
std::string nameIn(const Names<T>& names, T value)
{
  const auto found = std::find_if(names.begin(), names.end(),
    [value](const auto& name) { return name.second == value; });
  return found != names.end() ? found->first : "unknown";
}

} // namespace

const Names<Side>& sideNames()
{
  static const Names<Side> kNames = { { "interior", Side::Interior },
    { "exterior", Side::Exterior }, { "both", Side::Both } };
  return kNames;
}

const Names<Representation>& representationNames()
{
  static const Names<Representation> kNames = { { "surface", Representation::Surface },
    { "faces", Representation::Faces }, { "points", Representation::Points } };
  return kNames;
}

const Names<Topology>& topologyNames()
{
  static const Names<Topology> kNames = { { "selected", Topology::Selected },
    { "preserve", Topology::Preserve } };
  return kNames;
}

const Names<SignMethod>& signNames()
{
  static const Names<SignMethod> kNames = { { "auto", SignMethod::Auto },
    { "none", SignMethod::None }, { "pseudonormal", SignMethod::Pseudonormal },
    { "winding", SignMethod::Winding } };
  return kNames;
}

const Names<Engine>& engineNames()
{
  static const Names<Engine> kNames = { { "auto", Engine::Auto }, { "device", Engine::Device },
    { "rasteriser", Engine::Rasteriser }, { "processor", Engine::Processor } };
  return kNames;
}

const Names<ThicknessMethod>& thicknessMethodNames()
{
  static const Names<ThicknessMethod> kNames = { { "ball", ThicknessMethod::Ball },
    { "ray", ThicknessMethod::Ray }, { "wall", ThicknessMethod::Wall } };
  return kNames;
}

std::string nameOf(ThicknessMethod method)
{
  return nameIn(thicknessMethodNames(), method);
}

std::string nameOf(Side side)
{
  return nameIn(sideNames(), side);
}

std::string nameOf(Representation representation)
{
  return nameIn(representationNames(), representation);
}

std::string nameOf(SignMethod method)
{
  return nameIn(signNames(), method);
}

std::string nameOf(Topology topology)
{
  return nameIn(topologyNames(), topology);
}

std::string nameOf(Engine engine)
{
  return nameIn(engineNames(), engine);
}

} // namespace medial::app
