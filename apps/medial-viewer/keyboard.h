#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <functional>
#include <string>
#include <vector>

namespace medial::app
{

/// What the keys do, and the text that lists them.
class Keyboard
{
public:
  /// @param symbol of the key, as X names it: "h", "space".
  /// @param meaning a few words.
  void add(const std::string& symbol, const std::string& meaning, std::function<void()> act);

  /// Does what the key is for; nothing for keys that were not added.
  void press(const std::string& symbol) const;

  /// A line for each key.
  std::string help() const;

private:
  struct Key
  {
    std::string symbol;
    std::string meaning;
    std::function<void()> act;
  };
  std::vector<Key> keys_;
};

/// VTK's interaction by mouse, without VTK's keys.
class ViewerStyle : public vtkInteractorStyleTrackballCamera
{
public:
  static ViewerStyle* New();
  vtkTypeMacro(ViewerStyle, vtkInteractorStyleTrackballCamera);

  void OnChar() override {}

protected:
  ViewerStyle() = default;
};

} // namespace medial::app
