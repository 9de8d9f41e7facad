#pragma once

#include "proximity_results.h"
#include "scene.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <vector>

class vtkProp;

namespace medial::app
{

/// Draws frames as PNG files of 1600 x 1200 pixels, all from the same place: translucent meshes,
/// each in a colour of its own, an arrow from each contact along its normal, a line between the
/// closest points of meshes apart, and the figures in words. Needs no display.
class ProximityPicture
{
public:
  /// @param results must outlive this object.
  /// @param frames how many of them must fit into the view, from the first.
  /// @throws Failure NoGpu if there is no OpenGL.
  ProximityPicture(const ProximityResults& results, std::size_t frames);

  /// @throws Failure NoSpace if the file cannot be written completely. The message does not name
  ///   it.
  void draw(std::size_t frame, const std::filesystem::path& file);

private:
  void addBodies();
  void moveBodies(std::size_t frame);
  void aim(std::size_t frames);
  void add(const vtkSmartPointer<vtkProp>& prop);
  void addContacts(std::size_t frame);
  void addWitnesses(std::size_t frame);
  void addCaption(std::size_t frame);

  const ProximityResults& results_;
  Scene scene_;
  std::vector<vtkSmartPointer<vtkPolyData>> surfaces_; // of the bodies
  std::vector<vtkSmartPointer<vtkProp>> propsOfFrame_; // those that belong to one frame
  double scale_ = 1.0;                                 // half the height of the view, world units
};

} // namespace medial::app
