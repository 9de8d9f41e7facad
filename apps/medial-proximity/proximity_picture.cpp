#include "proximity_picture.h"

#include "actors.h"
#include "caption.h"
#include "captions.h"
#include "contact_data.h"
#include "vtk_messages.h"

#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCamera.h>
#include <vtkGlyph3D.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>

namespace medial::app
{
namespace
{

// Of the meshes, one after the other; told apart by people who see fewer colours, too.
constexpr std::array<Colour, 6> kBodyColours = { { { 0.00, 0.36, 0.67 }, { 0.90, 0.52, 0.00 },
  { 0.00, 0.58, 0.43 }, { 0.74, 0.42, 0.62 }, { 0.30, 0.66, 0.87 }, { 0.55, 0.50, 0.10 } } };
constexpr Colour kContactColour = { 0.78, 0.05, 0.10 };
constexpr Colour kWitnessColour = { 0.10, 0.11, 0.13 };
constexpr double kOpacity = 0.22;

// As shares of half the height of the picture.
constexpr double kArrowLength = 0.16;
constexpr double kContactRadius = 0.016;
constexpr double kWitnessRadius = 0.0055;

const Colour& colourOf(std::size_t body)
{
  return kBodyColours[body % kBodyColours.size()];
}

void paint(const SurfaceActors& surface, const Colour& colour)
{
  vtkProperty* faces = surface.faces->GetProperty();
  faces->SetColor(colour[0], colour[1], colour[2]);
  faces->SetOpacity(kOpacity);
  faces->SetAmbient(0.4);
  faces->SetDiffuse(0.6);
  vtkProperty* edges = surface.edges->GetProperty();
  edges->SetColor(colour[0], colour[1], colour[2]);
  edges->SetOpacity(0.6);
  edges->SetLineWidth(2.0F);
}

vtkSmartPointer<vtkActor> makeSolid(vtkAlgorithm* source, const Colour& colour)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(colour[0], colour[1], colour[2]);
  look->SetAmbient(0.35);
  look->SetDiffuse(0.7);
  return actor;
}

// Spheres of a radius at all points.
vtkSmartPointer<vtkActor> makeDots(vtkPolyData* points, double radius, const Colour& colour)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(16);
  vtkNew<vtkGlyph3D> dots;
  dots->SetInputData(points);
  dots->SetSourceConnection(sphere->GetOutputPort());
  dots->ScalingOff();
  dots->OrientOff();
  return makeSolid(dots, colour);
}

vtkSmartPointer<vtkActor> makeArrows(vtkPolyData* contacts, double length)
{
  vtkNew<vtkArrowSource> arrow;
  arrow->SetShaftResolution(24);
  arrow->SetTipResolution(24);
  arrow->SetShaftRadius(0.035);
  arrow->SetTipRadius(0.1);
  arrow->SetTipLength(0.3);
  vtkNew<vtkGlyph3D> arrows;
  arrows->SetInputData(contacts);
  arrows->SetSourceConnection(arrow->GetOutputPort());
  arrows->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Normal");
  arrows->SetVectorModeToUseVector();
  arrows->SetScaleModeToDataScalingOff();
  arrows->SetScaleFactor(length);
  return makeSolid(arrows, kContactColour);
}

vtkSmartPointer<vtkActor> makeTubes(vtkPolyData* lines, double radius)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(16);
  return makeSolid(tubes, kWitnessColour);
}

// The pairs that have two closest points to show.
std::vector<Proximity> apart(const std::vector<Proximity>& pairs)
{
  std::vector<Proximity> result;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(result),
    [](const Proximity& pair) { return !pair.intersect; });
  return result;
}

} // namespace

ProximityPicture::ProximityPicture(const ProximityResults& results, std::size_t frames)
  : results_(results)
{
  const VtkMessages messages;
  this->addBodies();
  this->aim(frames);
}

void ProximityPicture::addBodies()
{
  const std::vector<std::string> names = legend(results_.bodies);
  for (std::size_t i = 0; i < results_.bodies.size(); ++i)
  {
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->ShallowCopy(results_.bodies[i].sequence.surface);
    surfaces_.push_back(surface);
    const SurfaceActors actors = makeSurface(surface);
    paint(actors, colourOf(i));
    scene_.add(actors.faces);
    scene_.add(actors.edges);
  }
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const double height = 1.0 - kTextMargin - static_cast<double>(i + 1) * kLineShare;
    scene_.add(
      makeLine(names[i], height, i < results_.bodies.size() ? colourOf(i) : kWitnessColour));
  }
}

void ProximityPicture::moveBodies(std::size_t frame)
{
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
  {
    surfaces_[i]->SetPoints(results_.bodies[i].seenPoints(frame));
    surfaces_[i]->Modified();
  }
}

void ProximityPicture::aim(std::size_t frames)
{
  const auto forEachSurface = [&](const auto& call)
  {
    for (std::size_t frame = 0; frame < frames; ++frame)
    {
      this->moveBodies(frame);
      for (vtkPolyData* surface : surfaces_)
      {
        call(surface);
      }
    }
  };
  vtkBoundingBox bounds;
  forEachSurface([&](vtkPolyData* surface) { addSeenPoints(surface, bounds); });
  aimCamera(scene_.camera(), bounds);
  vtkBoundingBox seen;
  forEachSurface([&](vtkPolyData* surface) { addSeenPoints(surface, scene_.camera(), seen); });
  Margins margins;
  margins.top = shareOfLines(legend(results_.bodies).size());
  for (std::size_t frame = 0; frame < frames; ++frame)
  {
    margins.bottom = std::max(margins.bottom, shareOfLines(caption(results_, frame).size()));
  }
  scene_.fit(seen, margins);
  scale_ = scene_.camera()->GetParallelScale();
}

void ProximityPicture::add(const vtkSmartPointer<vtkProp>& prop)
{
  scene_.add(prop);
  propsOfFrame_.push_back(prop);
}

void ProximityPicture::addContacts(std::size_t frame)
{
  ContactData contacts;
  contacts.addContacts(results_.frames[frame].pairs, frame);
  if (contacts.polyData()->GetNumberOfPoints() > 0)
  {
    this->add(makeDots(contacts.polyData(), kContactRadius * scale_, kContactColour));
    this->add(makeArrows(contacts.polyData(), kArrowLength * scale_));
  }
}

void ProximityPicture::addWitnesses(std::size_t frame)
{
  ContactData witnesses;
  witnesses.addWitnesses(apart(results_.frames[frame].pairs), frame);
  if (witnesses.polyData()->GetNumberOfPoints() > 0)
  {
    this->add(makeDots(witnesses.polyData(), kContactRadius * scale_, kWitnessColour));
    this->add(makeTubes(witnesses.polyData(), kWitnessRadius * scale_));
  }
}

void ProximityPicture::addCaption(std::size_t frame)
{
  const std::vector<std::string> lines = caption(results_, frame);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const double height = kTextMargin + static_cast<double>(lines.size() - 1 - i) * kLineShare;
    this->add(makeLine(lines[i], height, kWitnessColour));
  }
}

void ProximityPicture::draw(std::size_t frame, const std::filesystem::path& file)
{
  const VtkMessages messages;
  for (vtkProp* prop : propsOfFrame_)
  {
    scene_.remove(prop);
  }
  propsOfFrame_.clear();
  this->moveBodies(frame);
  this->addContacts(frame);
  this->addWitnesses(frame);
  this->addCaption(frame);
  scene_.write(file);
}

} // namespace medial::app
