#pragma once

#include <chrono>

class vtkRenderer;

namespace medial::app
{

/// Draws drafts while something moves, and well when nothing has moved for a while. Translucent
/// surfaces are blended as they come in drafts; drawn well they are sorted by depth peeling, which
/// draws them once more for each of their layers.
class DrawingQuality
{
public:
  using Clock = std::chrono::steady_clock;

  /// From now on the renderer draws drafts.
  explicit DrawingQuality(vtkRenderer* renderer);

  /// To be told when the renderer has drawn.
  void drawn(Clock::time_point now = Clock::now());

  /// Whether the last drawing was a draft, a quarter of a second ago or more.
  bool due(Clock::time_point now = Clock::now()) const;

  /// Draws well, once.
  void drawWell();

private:
  vtkRenderer* renderer_;
  Clock::time_point drawnAt_;
  bool draft_ = false; // what was drawn last
};

} // namespace medial::app
