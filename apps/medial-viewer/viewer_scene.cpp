#include "viewer_scene.h"

#include "caption.h"
#include "colours.h"
#include "scalar_bar.h"

#include <vtkCoordinate.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

namespace medial::app
{
namespace
{

constexpr int kFontSize = 15;

struct Colouring
{
  const char* array;
  const char* title;
};

Colouring colouringOf(ColourBy colour)
{
  switch (colour)
  {
    case ColourBy::Angle:
      return { "SeparationAngle", "Angle\n(degrees)" };
    case ColourBy::Thickness:
      return { "Thickness", "Thickness\n(world units)" };
    case ColourBy::Radius:
      break;
  }
  return { "Radius", "Radius\n(world units)" };
}

void layOut(vtkTextActor* actor, double x, double y)
{
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->GetPositionCoordinate()->SetValue(x, y);
  vtkTextProperty* text = actor->GetTextProperty();
  text->SetFontSize(kFontSize);
  text->SetColor(0.15, 0.17, 0.2);
  text->SetVerticalJustificationToTop();
  text->SetLineSpacing(1.2);
  text->SetBackgroundColor(1.0, 1.0, 1.0);
  text->SetBackgroundOpacity(0.8);
}

void toggle(vtkProp* prop)
{
  prop->SetVisibility(prop->GetVisibility() != 0 ? 0 : 1);
}

} // namespace

ViewerScene::ViewerScene(vtkRenderer* renderer, vtkPolyData* surface, vtkPolyData* axis)
  : renderer_(renderer)
  , surface_(makeSurface(surface))
  , axis_(makeAxis(axis, colours_, "Radius"))
  , bar_(makeScalarBar(colours_, "Radius", kFontSize))
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetUseFXAA(true);
  layOut(status_, 0.015, 0.985);
  layOut(help_, 0.015, 0.8);
  help_->GetTextProperty()->SetFontFamilyToCourier();
  help_->VisibilityOff();
  for (vtkProp* prop : std::initializer_list<vtkProp*>{ surface_.faces, surface_.edges, axis_ })
  {
    prop->PickableOff(); // so that the mouse reaches the slice through them
    renderer->AddViewProp(prop);
  }
  for (vtkProp* prop : std::initializer_list<vtkProp*>{ bar_, status_, help_ })
  {
    renderer->AddViewProp(prop);
  }
}

void ViewerScene::colourAxis(ColourBy colour, double max)
{
  const Colouring colouring = colouringOf(colour);
  setColours(colours_, max);
  setTicks(bar_, max);
  axis_->GetMapper()->SelectColorArray(colouring.array);
  bar_->SetTitle(colouring.title);
  colour_ = colour;
  colourSkeleton();
}

// It has a radius, and neither angle nor thickness.
void ViewerScene::colourSkeleton()
{
  if (showsSkeleton())
  {
    skeleton_.branches->GetMapper()->SetScalarVisibility(colour_ == ColourBy::Radius ? 1 : 0);
    skeleton_.branches->GetProperty()->SetColor(0.15, 0.17, 0.2);
  }
}

void ViewerScene::setSkeleton(vtkPolyData* skeleton)
{
  for (const auto& actor : { skeleton_.branches, skeleton_.ends })
  {
    if (actor != nullptr)
    {
      renderer_->RemoveViewProp(actor);
    }
  }
  skeleton_ = skeleton != nullptr ? makeSkeleton(skeleton, colours_) : SkeletonActors{};
  for (const auto& actor : { skeleton_.branches, skeleton_.ends })
  {
    if (actor != nullptr)
    {
      actor->PickableOff();
      renderer_->AddViewProp(actor);
    }
  }
  colourSkeleton();
}

void ViewerScene::setStatus(const std::string& text)
{
  status_->SetInput(drawableText(text).c_str());
}

void ViewerScene::toggleSurface()
{
  toggle(surface_.faces);
  toggle(surface_.edges);
}

void ViewerScene::toggleAxis()
{
  toggle(axis_);
}

void ViewerScene::toggleHelp()
{
  toggle(help_);
}

} // namespace medial::app
