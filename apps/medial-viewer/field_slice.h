#pragma once

#include <vtkImagePlaneWidget.h>
#include <vtkNew.h>
#include <vtkTrivialProducer.h>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindowInteractor;

namespace medial::app
{

/// A plane through the distance field. The left button drags it along its normal, or turns it at
/// its border. It stays where it is when the field changes. Red outside, blue inside, in bands
/// whose borders are lines of equal distance.
class FieldSlice
{
public:
  FieldSlice(vtkRenderWindowInteractor* interactor, vtkRenderer* renderer);
  /// The interactor may be gone by then.
  ~FieldSlice();
  FieldSlice(const FieldSlice&) = delete;
  FieldSlice& operator=(const FieldSlice&) = delete;

  /// @param field with the active scalars Distance; may be the previous image with new values.
  /// @param max distances of this and more share the last colour, world units.
  void setField(vtkImageData* field, double max);

  void setVisible(bool visible);
  bool visible() { return widget_->GetEnabled() != 0; }

  /// Puts the plane across the middle of the field.
  /// @param axis of the grid that is the plane's normal, in [0, 2].
  void setNormal(int axis);

  /// A point on it, and its normal, in world coordinates.
  const double* centre() { return widget_->GetCenter(); }
  const double* normal() { return widget_->GetNormal(); }

private:
  vtkNew<vtkImagePlaneWidget> widget_;
  vtkNew<vtkTrivialProducer> source_;
  int dimensions_[3] = { 0, 0, 0 };
};

} // namespace medial::app
