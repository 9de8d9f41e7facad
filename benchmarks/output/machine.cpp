#include "output/machine.h"

#include "medial/device.h"
#include "medial/error.h"

#include <array>
#include <ctime>
#include <fstream>
#include <thread>

namespace medial::benchmark
{
namespace
{

std::string processorName()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("model name", 0) == 0)
    {
      return line.substr(line.find(':') + 2);
    }
  }
  return {};
}

std::string today()
{
  const std::time_t now = std::time(nullptr);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  return text.data();
}

} // namespace

Machine describeMachine()
{
  Machine machine;
  try
  {
    const Device device = queryDevice();
    machine.renderer = device.renderer;
    machine.version = device.version;
  }
  catch (const Error& error)
  {
    machine.renderer = error.what();
  }
  machine.processor = processorName();
  machine.cores = std::thread::hardware_concurrency();
  machine.date = today();
  return machine;
}

} // namespace medial::benchmark
