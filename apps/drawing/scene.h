#pragma once

#include "camera.h"
#include "colours.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

class vtkPolyData;

namespace medial::app
{

class EglRenderWindow;

///@{
/// How bright the two lights of an edge-on view are: one at its own camera, one at that of the main
/// picture. The second keeps the colours of faces that look to the front.
constexpr double kOwnLight = 0.6;
constexpr double kFrontLight = 0.8;
///@}

/// What the programs' pictures have in common: 1600 x 1200 pixels on white, a view that fits, and
/// maybe a scalar bar on the right. Needs no display.
class Scene
{
public:
  /// @throws Failure NoGpu if there is no OpenGL.
  Scene();

  void add(vtkProp* prop) { renderer_->AddViewProp(prop); }
  void remove(vtkProp* prop) { renderer_->RemoveViewProp(prop); }

  /// @param nameOfNone label for places without a value; null if all have one.
  void addScalarBar(vtkColorTransferFunction* colours, const char* title,
    const char* nameOfNone = nullptr);

  /// The camera, for what fit() needs.
  vtkCamera* camera() { return renderer_->GetActiveCamera(); }

  /// Moves and scales the view until the bounds fit.
  /// @param bounds in the camera's coordinates.
  void fit(const vtkBoundingBox& bounds, const Margins& margins);

  /// Writes a PNG file of the scene as the camera sees it.
  /// @throws Failure NoSpace if the file cannot be written completely. The message does not name
  ///   it.
  void write(const std::filesystem::path& file);

  /// Adds lines of text at the upper left.
  void addCaption(const std::vector<std::string>& lines);

  /// Writes a PNG file of the scene with a scalar bar. Strips below show it from behind, if there
  /// is something to be seen there only, and what is flat also from its edge; words name them.
  /// @param shown what must fit into it; the first one decides where to look from.
  /// @param behind what only the view from behind has.
  /// @throws Failure NoSpace if the file cannot be written completely. The message does not name
  ///   it.
  void draw(std::initializer_list<vtkPolyData*> shown, const std::filesystem::path& file,
    const std::vector<vtkSmartPointer<vtkProp>>& behind = {});

private:
  /// Shows what is there in one more strip, too.
  /// @param bottom of the strip and its height, as shares of the picture's.
  /// @param aim sets the direction of the strip's camera.
  vtkRenderer* addView(const char* name, std::initializer_list<vtkPolyData*> shown, double bottom,
    double height, void (*aim)(vtkCamera*, vtkPolyData*));

  vtkSmartPointer<EglRenderWindow> window_;
  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderer> overlay_; ///< text and scalar bar, above all views
  std::size_t captionLines_ = 0;
};

} // namespace medial::app
