#include "viewer.h"

#include "camera.h"
#include "event_call.h"
#include "failure.h"
#include "interrupt.h"
#include "option_names.h"
#include "output_file.h"
#include "png_file.h"
#include "scalar_bar.h"
#include "vtk_messages.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace medial::app
{
namespace
{

constexpr unsigned long kTick = 16; // milliseconds between two looks at the clock
constexpr double kRoom = 0.88;      // for the mesh, above the sliders

const SliderStyle kAngleStyle = { "separation angle (degrees)", "%.0f", kLeastViewerAngle,
  kGreatestViewerAngle, 0.05, 0.42 };
const SliderStyle kResolutionStyle = { "resolution (grid points)", "%.0f", kLeastViewerResolution,
  kGreatestViewerResolution, 0.48, 0.82 };

template <typename... Values>
std::string text(const char* format, Values... values)
{
  char line[256];
  std::snprintf(line, sizeof(line), format, values...);
  return line;
}

double greatestRadius(vtkPolyData* axis)
{
  return axis->GetNumberOfPoints() > 0 ? axis->GetPointData()->GetArray("Radius")->GetRange()[1]
                                       : 0.0;
}

// The corners of the box around all frames.
vtkSmartPointer<vtkPolyData> cornersOf(const Bounds& bounds)
{
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners->InsertNextPoint(((i & 1) != 0 ? bounds.max : bounds.min)[0],
      ((i & 2) != 0 ? bounds.max : bounds.min)[1], ((i & 4) != 0 ? bounds.max : bounds.min)[2]);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(corners);
  return result;
}

vtkPolyData* asDrawn(const Sequence& sequence)
{
  sequence.surface->GetPointData()->SetScalars(nullptr);
  return sequence.surface;
}

} // namespace

Viewer::Viewer(Sequence sequence, const ViewerOptions& options)
  : options_(options)
  , sequence_(std::move(sequence))
  , source_(sequence_, options)
  , window_("medial-viewer", options.width, options.height)
  , scene_(window_.renderer, asDrawn(sequence_), selected_)
  , slice_(window_.interactor, window_.renderer)
  , angle_(window_.interactor, kAngleStyle, options.angle)
  , resolution_(window_.interactor, kResolutionStyle, options.resolution)
  , playing_(options.play)
{
  showFrame(0);
  slice_.setVisible(true);
  resetCamera();
  addKeys();
  listen();
}

// Widgets draw when they go, and events would reach members that are gone.
Viewer::~Viewer()
{
  window_.interactor->EnableRenderOff();
  window_.interactor->RemoveObservers(vtkCommand::CharEvent);
  window_.interactor->RemoveObservers(vtkCommand::TimerEvent);
  window_.window->RemoveObservers(vtkCommand::StartEvent);
}

void Viewer::listen()
{
  observeEvent(window_.interactor, vtkCommand::CharEvent, [this] { attempt([&] { press(); }); });
  observeEvent(window_.window, vtkCommand::StartEvent,
    [this]
    {
      rate_.tick();
      scene_.setStatus(describe());
    });
  observeEvent(window_.interactor, vtkCommand::TimerEvent, [this] { attempt([&] { tick(); }); });
  angle_.onMove([this](double) { attempt([&] { select(); }); });
  resolution_.onRelease(
    [this](double value)
    {
      attempt(
        [&]
        {
          compute(static_cast<int>(std::lround(value)));
          window_.window->Render();
        });
    });
  window_.interactor->Initialize();
  window_.interactor->CreateRepeatingTimer(kTick);
}

void Viewer::press()
{
  const char* symbol = window_.interactor->GetKeySym();
  note_.clear();
  keyboard_.press(symbol != nullptr ? symbol : "");
  window_.window->Render();
}

void Viewer::addKeys()
{
  keyboard_.add("h", "show or hide this list", [this] { scene_.toggleHelp(); });
  keyboard_.add("space", "play or pause the sequence",
    [this] { playing_ = !playing_ && sequence_.frames.size() > 1; });
  keyboard_.add("n", "next frame", [this] { step(1); });
  keyboard_.add("b", "frame before", [this] { step(-1); });
  keyboard_.add("c", "colour by radius, angle or thickness", [this] { nextColour(); });
  keyboard_.add("s", "show or hide the surface", [this] { scene_.toggleSurface(); });
  keyboard_.add("a", "show or hide the axis", [this] { scene_.toggleAxis(); });
  keyboard_.add("d", "show or hide the slice of the distance field",
    [this] { slice_.setVisible(!slice_.visible()); });
  keyboard_.add("x", "slice across x", [this] { turnSlice(0); });
  keyboard_.add("y", "slice across y", [this] { turnSlice(1); });
  keyboard_.add("z", "slice across z", [this] { turnSlice(2); });
  keyboard_.add("r", "reset the view", [this] { resetCamera(); });
  keyboard_.add("p", "write a picture of the window", [this] { savePicture(); });
  keyboard_.add("q", "leave", [this] { window_.interactor->TerminateApp(); });
  scene_.setHelp(keyboard_.help());
}

void Viewer::attempt(const std::function<void()>& work)
{
  if (failure_)
  {
    return;
  }
  try
  {
    work();
  }
  catch (...)
  {
    failure_ = std::current_exception();
    window_.interactor->TerminateApp();
  }
}

void Viewer::run()
{
  window_.window->Render();
  window_.interactor->Start();
  if (failure_)
  {
    std::rethrow_exception(failure_);
  }
}

void Viewer::tick()
{
  if (interrupted())
  {
    throw Failure(ExitCode::Interrupted, "interrupted");
  }
  if (playing_)
  {
    showFrame((frame_ + 1) % sequence_.frames.size());
    window_.window->Render();
  }
}

void Viewer::step(int frames)
{
  playing_ = false;
  const int count = static_cast<int>(sequence_.frames.size());
  showFrame(static_cast<std::size_t>((static_cast<int>(frame_) + frames + count) % count));
}

void Viewer::showFrame(std::size_t frame)
{
  frame_ = frame;
  sequence_.surface->SetPoints(sequence_.frames[frame].seen);
  compute(static_cast<int>(std::lround(resolution_.value())));
}

void Viewer::compute(int resolution)
{
  source_.compute(sequence_.frames[frame_], resolution);
  ++computations_;
  greatestRadius_ = std::fmax(greatestRadius_, greatestRadius(source_.axis()));
  const double scale = greatestRadius_ > 0.0 ? greatestRadius_ : sequence_.bounds.diagonal();
  slice_.setField(source_.field(), scale);
  colour();
  select();
  window_.renderer->ResetCameraClippingRange();
}

void Viewer::select()
{
  selectByAngle(source_.axis(), angle_.value(), selected_);
}

void Viewer::colour()
{
  const double radius = greatestRadius_ > 0.0 ? greatestRadius_ : 1.0;
  const double greatest = options_.colour == ColourBy::Angle ? 180.0
    : options_.colour == ColourBy::Radius                    ? radius
                                                             : 2.0 * radius;
  scene_.colourAxis(options_.colour, greatest);
}

void Viewer::nextColour()
{
  options_.colour = options_.colour == ColourBy::Radius ? ColourBy::Angle
    : options_.colour == ColourBy::Angle                ? ColourBy::Thickness
                                                        : ColourBy::Radius;
  colour();
}

void Viewer::turnSlice(int axis)
{
  slice_.setVisible(true);
  slice_.setNormal(axis);
}

void Viewer::resetCamera()
{
  vtkCamera* camera = window_.renderer->GetActiveCamera();
  const vtkSmartPointer<vtkPolyData> shown =
    sequence_.frames.size() > 1 ? cornersOf(sequence_.bounds) : sequence_.surface;
  aimCamera(camera, shown);
  const int* size = window_.window->GetSize();
  fitView(window_.renderer, { shown }, static_cast<double>(size[0]) / size[1], kBarShare);
  camera->Zoom(kRoom);
  window_.renderer->ResetCameraClippingRange();
}

void Viewer::savePicture()
{
  const std::string stem = options_.inputs.front().stem().string();
  std::filesystem::path file;
  for (int i = 1; file.empty() || std::filesystem::exists(file); ++i)
  {
    file = stem + text("_viewer_%03d.png", i);
  }
  try
  {
    writePicture(file);
    note_ = "wrote " + file.string();
  }
  catch (const Failure& failure)
  {
    note_ = failure.what();
  }
}

void Viewer::writePicture(const std::filesystem::path& file)
{
  OutputFile output(file);
  namingFile(file,
    [&]
    {
      window_.window->Render();
      writePng(window_.window, output.open());
      output.commit();
    });
}

std::string Viewer::describe() const
{
  const RunStatistics& statistics = source_.statistics();
  std::string lines = sequence_.frames[frame_].name;
  if (sequence_.frames.size() > 1)
  {
    lines += text(", frame %zu of %zu%s", frame_ + 1, sequence_.frames.size(),
      playing_ ? "" : " (paused)");
  }
  lines += source_.sign() == SignMethod::None ? ", unsigned\n" : "\n";
  lines += text("%.1f frames per second\n", rate_.perSecond());
  lines += text("axis: %lld cells; field and axis computed in %.3f s by the %s\n",
    static_cast<long long>(selected_->GetNumberOfCells()), source_.seconds(),
    nameOf(statistics.evaluator).c_str());
  lines += "compute: " + statistics.device.renderer + "\nwindow: " + window_.device + "\n";
  return lines + (note_.empty() ? "keys: h" : note_);
}

void runViewer(const ViewerOptions& options)
{
  Sequence sequence = readSequence(options.inputs);
  const VtkMessages messages;
  Viewer viewer(std::move(sequence), options);
  if (options.screenshot.empty())
  {
    viewer.run();
    return;
  }
  viewer.writePicture(options.screenshot);
}

} // namespace medial::app
