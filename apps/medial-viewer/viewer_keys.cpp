#include "viewer.h"

#include "failure.h"
#include "input/input_file.h"
#include "viewpoint.h"

// What the keys do.
namespace medial::app
{

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
  keyboard_.add("b", "previous frame", [this] { step(-1); });
  keyboard_.add("c", "colour by radius, angle or thickness", [this] { nextColour(); });
  keyboard_.add("s", "show or hide the surface", [this] { scene_.toggleSurface(); });
  keyboard_.add("a", "show or hide the axis", [this] { scene_.toggleAxis(); });
  keyboard_.add("k", "show the skeleton instead of the axis", [this] { toggleSkeleton(); });
  keyboard_.add("d", "show or hide the slice of the distance field",
    [this] { slice_.setVisible(!slice_.visible()); });
  keyboard_.add("x", "slice across x", [this] { turnSlice(0); });
  keyboard_.add("y", "slice across y", [this] { turnSlice(1); });
  keyboard_.add("z", "slice across z", [this] { turnSlice(2); });
  keyboard_.add("r", "reset the view", [this] { lookAt(window_.renderer, sequence_); });
  keyboard_.add("e", "look edge-on at what is flat",
    [this] { lookAt(window_.renderer, sequence_, View::Edge); });
  keyboard_.add("p", "write a picture of the window", [this] { savePicture(); });
  keyboard_.add("q", "quit", [this] { window_.leave(); });
  keyboard_.add("Escape", "cancel a computation", [] {}); // Cancellation handles it
  scene_.setHelp(keyboard_.help());
}

void Viewer::step(int frames)
{
  playing_ = false;
  const int count = static_cast<int>(sequence_.frames.size());
  showFrame(static_cast<std::size_t>((static_cast<int>(frame_) + frames + count) % count));
}

void Viewer::nextColour()
{
  options_.colour = options_.colour == ColourBy::Radius ? ColourBy::Angle
    : options_.colour == ColourBy::Angle                ? ColourBy::Thickness
                                                        : ColourBy::Radius;
  colour();
}

void Viewer::toggleSkeleton()
{
  if (scene_.showsSkeleton())
  {
    scene_.setSkeleton(nullptr);
  }
  else
  {
    note_ = "computing the skeleton; Escape cancels";
    window_.window->Render();
    note_.clear();
    showSkeleton();
  }
  scene_.setAxisVisible(!scene_.showsSkeleton());
}

// Where a mesh has no inside it has no skeleton, and the window says so.
void Viewer::showSkeleton()
{
  try
  {
    source_.computeSkeleton(sequence_.frames[frame_]);
    scene_.setSkeleton(source_.skeleton());
  }
  catch (const Failure& failure)
  {
    if (failure.exitCode() != ExitCode::BadInput)
    {
      throw;
    }
    note_ = failure.what();
    scene_.setSkeleton(nullptr);
    scene_.setAxisVisible(true);
  }
}

void Viewer::turnSlice(int axis)
{
  slice_.setVisible(true);
  slice_.setNormal(axis);
}

void Viewer::savePicture()
{
  const std::string stem = stemOf(sequence_.frames[frame_].name);
  std::filesystem::path file;
  std::error_code ignored;
  for (int i = 1; file.empty() || std::filesystem::exists(file, ignored); ++i)
  {
    file = stem + "_viewer_" + std::to_string(i) + ".png";
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

} // namespace medial::app
