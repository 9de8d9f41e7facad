#pragma once

#include "colours.h"
#include "egl_render_window.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

#include <filesystem>
#include <initializer_list>

class vtkPolyData;

namespace medial::app
{

/// What the program's pictures have in common: 1600 x 1200 pixels on white, a view that fits, a
/// scalar bar on the right. Needs no display.
class Scene
{
public:
  /// @throws Failure NoGpu if there is no OpenGL.
  Scene();

  void add(vtkProp* prop) { renderer_->AddViewProp(prop); }

  /// @param nameOfNone label for places without a value; null if all have one.
  void addScalarBar(vtkColorTransferFunction* colours, const char* title,
    const char* nameOfNone = nullptr);

  /// Writes a PNG file of the scene.
  /// @param shown what must fit into it; the first one decides where to look from.
  /// @throws Failure NoSpace if the file cannot be written completely. The message does not name
  ///   it.
  void draw(std::initializer_list<vtkPolyData*> shown, const std::filesystem::path& file);

private:
  vtkNew<EglRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
};

} // namespace medial::app
