#include "support/printing.h"

#include "medial/compute_medial_axis.h"
#include "medial/engine.h"
#include "medial/grid.h"
#include "medial/side.h"
#include "medial/sign_method.h"

#include <ostream>

namespace medial
{

std::ostream& operator<<(std::ostream& stream, Engine engine)
{
  switch (engine)
  {
    case Engine::Auto:
      return stream << "Auto";
    case Engine::Rasteriser:
      return stream << "Rasteriser";
    case Engine::Device:
      return stream << "Device";
    case Engine::Processor:
      return stream << "Processor";
  }
  return stream;
}

std::ostream& operator<<(std::ostream& stream, Side side)
{
  switch (side)
  {
    case Side::Interior:
      return stream << "Interior";
    case Side::Exterior:
      return stream << "Exterior";
    case Side::Both:
      return stream << "Both";
  }
  return stream;
}

std::ostream& operator<<(std::ostream& stream, SignMethod method)
{
  switch (method)
  {
    case SignMethod::Auto:
      return stream << "Auto";
    case SignMethod::None:
      return stream << "None";
    case SignMethod::Pseudonormal:
      return stream << "Pseudonormal";
    case SignMethod::Winding:
      return stream << "Winding";
  }
  return stream;
}

std::ostream& operator<<(std::ostream& stream, Topology topology)
{
  switch (topology)
  {
    case Topology::Selected:
      return stream << "Selected";
    case Topology::Preserve:
      return stream << "Preserve";
  }
  return stream;
}

std::ostream& operator<<(std::ostream& stream, const Extent& extent)
{
  const auto& [min, max] = extent;
  return stream << '(' << min[0] << ", " << min[1] << ", " << min[2] << ") to (" << max[0] << ", "
                << max[1] << ", " << max[2] << ')';
}

} // namespace medial
