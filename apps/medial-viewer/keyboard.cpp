#include "keyboard.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <utility>

namespace medial::app
{

vtkStandardNewMacro(ViewerStyle);

void Keyboard::add(const std::string& symbol, const std::string& meaning, std::function<void()> act)
{
  keys_.push_back({ symbol, meaning, std::move(act) });
}

void Keyboard::press(const std::string& symbol) const
{
  const auto key =
    std::find_if(keys_.begin(), keys_.end(), [&](const Key& k) { return k.symbol == symbol; });
  if (key != keys_.end())
  {
    key->act();
  }
}

std::string Keyboard::help() const
{
  constexpr std::size_t kWidth = 8;
  std::string text;
  for (const Key& key : keys_)
  {
    const std::size_t gap = kWidth - std::min(kWidth - 1, key.symbol.size());
    text += key.symbol + std::string(gap, ' ') + key.meaning + "\n";
  }
  return text;
}

} // namespace medial::app
