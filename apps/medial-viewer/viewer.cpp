#include "viewer.h"

#include "colours.h"
#include "event_call.h"
#include "failure.h"
#include "interrupt.h"
#include "output/output_file.h"
#include "png_file.h"
#include "viewer_status.h"
#include "viewpoint.h"
#include "vtk_messages.h"

#include <vtkCommand.h>
#include <vtkPointData.h>

#include <cmath>
#include <new>
#include <utility>

namespace medial::app
{
namespace
{

constexpr unsigned long kTick = 16; // milliseconds between two timer events

const SliderStyle kAngleStyle = { "separation angle (degrees)", "%.0f", kMinViewerAngle,
  kMaxViewerAngle, 0.05, 0.42 };

SliderStyle resolutionStyle(const ViewerOptions& options)
{
  return { "resolution (grid points)", "%.0f", kMinViewerResolution,
    static_cast<double>(options.maxResolution), 0.48, 0.82 };
}

// Where a computation needs too much memory, or the user cancels it, the window keeps what it
// showed before.
bool mayStay(const Failure& failure)
{
  return failure.exitCode() == ExitCode::NoSpace ||
    (failure.exitCode() == ExitCode::Interrupted && !interrupted());
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
  , source_(sequence_, options, &cancellation_)
  , window_("medial-viewer", options.width, options.height)
  , quality_(window_.renderer)
  , scene_(window_.renderer, asDrawn(sequence_), selected_)
  , slice_(window_.interactor, window_.renderer)
  , angle_(window_.interactor, kAngleStyle, options.angle)
  , resolution_(window_.interactor, resolutionStyle(options), options.resolution)
  , playing_(options.play && sequence_.frames.size() > 1)
{
  showFrame(0);
  slice_.setVisible(true);
  lookAt(window_.renderer, sequence_);
  cancellation_.watch(window_.window);
  addKeys();
  listen();
}

// Widgets draw when they are destroyed, and events would reach members that no longer exist.
Viewer::~Viewer()
{
  window_.interactor->EnableRenderOff();
  window_.interactor->RemoveObservers(vtkCommand::CharEvent);
  window_.interactor->RemoveObservers(vtkCommand::TimerEvent);
  window_.window->RemoveObservers(vtkCommand::StartEvent);
  window_.window->RemoveObservers(vtkCommand::EndEvent);
}

void Viewer::listen()
{
  observeEvent(window_.interactor, vtkCommand::CharEvent, [this] { attempt([&] { press(); }); });
  observeEvent(window_.window, vtkCommand::StartEvent,
    [this]
    {
      rate_.tick();
      scene_.setStatus(statusText());
    });
  observeEvent(window_.window, vtkCommand::EndEvent, [this] { quality_.drawn(); });
  observeEvent(window_.interactor, vtkCommand::TimerEvent, [this] { attempt([&] { tick(); }); });
  angle_.onMove([this](double) { attempt([&] { select(); }); });
  angle_.onRelease([this](double) { attempt([&] { sharpen(); }); });
  resolution_.onRelease([this](double value)
    { attempt([&] { changeResolution(static_cast<int>(std::lround(value))); }); });
  window_.interactor->CreateRepeatingTimer(kTick);
}

void Viewer::attempt(const std::function<void()>& work)
{
  if (failure_)
  {
    return;
  }
  try
  {
    attemptAndStay(work);
  }
  catch (...)
  {
    failure_ = std::current_exception();
    window_.leave();
  }
}

void Viewer::attemptAndStay(const std::function<void()>& work)
{
  std::string problem;
  try
  {
    work();
    return;
  }
  catch (const Failure& failure)
  {
    if (!mayStay(failure))
    {
      throw;
    }
    problem = failure.what();
  }
  catch (const std::bad_alloc&)
  {
    problem = "out of memory";
  }
  note_ = problem;
  playing_ = false;
  resolution_.setValue(source_.resolution());
  angle_.setValue(std::fmax(angle_.value(), source_.angle()));
  window_.window->Render();
}

void Viewer::run()
{
  window_.window->Render();
  window_.loop();
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
  else if (quality_.due() && !dragging())
  {
    drawWell();
  }
}

// While the user drags, VTK's styles and widgets ask for another update rate.
bool Viewer::dragging()
{
  return window_.window->GetDesiredUpdateRate() > window_.interactor->GetStillUpdateRate();
}

void Viewer::showFrame(std::size_t frame)
{
  compute(frame, static_cast<int>(std::lround(resolution_.value())), angle_.value());
}

void Viewer::changeResolution(int resolution)
{
  computeAndDraw("a resolution of " + std::to_string(resolution), resolution);
}

// Gives the axis smooth borders for the slider's angle.
void Viewer::sharpen()
{
  if (!playing_ && angle_.value() != source_.angle())
  {
    computeAndDraw("an angle of " + std::to_string(std::lround(angle_.value())),
      source_.resolution());
  }
}

void Viewer::computeAndDraw(const std::string& with, int resolution)
{
  note_ = "computing with " + with + "; Escape cancels";
  window_.window->Render();
  note_.clear();
  compute(frame_, resolution, angle_.value());
  window_.window->Render();
}

void Viewer::compute(std::size_t frame, int resolution, double angle)
{
  source_.compute(sequence_.frames[frame], resolution, angle);
  ++computations_;
  frame_ = frame;
  sequence_.surface->SetPoints(sequence_.frames[frame].seen);
  maxRadius_ = std::fmax(maxRadius_, maxRadius(source_.axis()));
  const double scale = maxRadius_ > 0.0 ? maxRadius_ : sequence_.bounds.diagonal();
  slice_.setField(source_.field(), scale);
  if (scene_.showsSkeleton())
  {
    showSkeleton();
  }
  colour();
  select();
  window_.renderer->ResetCameraClippingRange();
}

// Borders are smooth for the angle that the axis was computed for. While the slider moves, whole
// cells are shown or not.
void Viewer::select()
{
  const double angle = angle_.value();
  if (!playing_ && angle < source_.angle())
  {
    compute(frame_, source_.resolution(), kMinViewerAngle);
  }
  else if (angle > source_.angle())
  {
    selectByAngle(source_.axis(), angle, selected_);
  }
  else
  {
    selected_->ShallowCopy(source_.axis());
  }
}

void Viewer::colour()
{
  const double radius = scaleEnd(maxRadius_);
  const double max = options_.colour == ColourBy::Angle ? kAngleScaleEnd
    : options_.colour == ColourBy::Radius               ? radius
                                                        : 2.0 * radius;
  scene_.colourAxis(options_.colour, max);
}

void Viewer::writePicture(const std::filesystem::path& file)
{
  OutputFile output(file);
  namingFile(file,
    [&]
    {
      drawWell();
      writePng(window_.window, output.open());
      output.commit();
    });
}

std::string Viewer::statusText() const
{
  ViewerStatus status;
  status.name = sequence_.frames[frame_].name;
  status.side = options_.side;
  status.frame = frame_;
  status.frames = sequence_.frames.size();
  status.playing = playing_;
  status.drawingsPerSecond = rate_.perSecond();
  status.cells = selected_->GetNumberOfCells();
  status.device = window_.device;
  status.note = note_;
  return describe(status, source_);
}

void runViewer(const ViewerOptions& options)
{
  std::set_new_handler(nullptr); // what does not fit into memory is refused, and the window stays
  if (!options.screenshot.empty())
  {
    const OutputFile writable(options.screenshot); // throws before anything is computed
  }
  Sequence sequence = readSequence(options.inputs, options.scan);
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
