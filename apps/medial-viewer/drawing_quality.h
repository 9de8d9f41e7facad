#pragma once

#include <chrono>

class vtkRenderer;

namespace medial::app
{

/// Draws drafts while something moves, and a good picture once nothing has moved for a while.
/// Drafts blend translucent surfaces unsorted; a good picture sorts them by depth peeling, which
/// draws them once more for each of their layers.
class DrawingQuality
{
public:
  using Clock = std::chrono::steady_clock;

  /// Makes the renderer draw drafts.
  explicit DrawingQuality(vtkRenderer* renderer);

  /// Call it when the renderer has drawn.
  void drawn(Clock::time_point now = Clock::now());

  /// Whether the last drawing was a draft, a quarter of a second ago or more.
  bool due(Clock::time_point now = Clock::now()) const;

  /// Draws a good picture, once.
  void drawWell();

private:
  vtkRenderer* renderer_;
  Clock::time_point drawnAt_;
  bool draft_ = false; // the last drawing
};

} // namespace medial::app
