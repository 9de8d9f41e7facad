#include "drawing_quality.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

namespace medial::app
{
namespace
{

constexpr int kPeels = 4; // layers of translucent surfaces that are sorted
constexpr std::chrono::milliseconds kStill(250);

} // namespace

DrawingQuality::DrawingQuality(vtkRenderer* renderer)
  : renderer_(renderer)
{
  renderer_->SetMaximumNumberOfPeels(kPeels);
  renderer_->SetUseDepthPeeling(false);
}

void DrawingQuality::drawn(Clock::time_point now)
{
  draft_ = renderer_->GetUseDepthPeeling() == 0;
  drawnAt_ = now;
}

bool DrawingQuality::due(Clock::time_point now) const
{
  return draft_ && now - drawnAt_ >= kStill;
}

void DrawingQuality::drawWell()
{
  renderer_->SetUseDepthPeeling(true);
  renderer_->GetRenderWindow()->Render();
  renderer_->SetUseDepthPeeling(false);
}

} // namespace medial::app
