#pragma once

#include "affine_transform.h"
#include "input/sequence.h"
#include "progress_bar.h"
#include "proximity_command.h"

#include <vtkPoints.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

namespace medial::app
{

/// One of the meshes, in all its frames.
struct Body
{
  std::filesystem::path input;              ///< as the user gave it
  std::vector<std::filesystem::path> files; ///< one, or one a frame
  Sequence sequence;
  std::vector<AffineTransform> transforms; ///< none, one, or one a frame
  std::filesystem::path transformFile;     ///< where they come from; empty for the command line
  bool closed = false;                     ///< in the first frame

  /// Number of frames that the body itself has; 1 if it stands still.
  std::size_t frames() const;

  /// Points of Sequence::mesh in a frame, transformed.
  std::vector<Point3> points(std::size_t frame) const;
  /// Points of Sequence::surface in a frame, transformed.
  vtkSmartPointer<vtkPoints> seenPoints(std::size_t frame) const;
  /// Whether its points in a frame are others than in the one before, or in its file at first.
  bool moves(std::size_t frame) const;
  /// The file of a frame, for messages.
  std::filesystem::path file(std::size_t frame) const;
};

/// The files of an input: itself, or one for each frame of a sequence, from a folder or a pattern.
/// @throws Failure BadInput if there are none.
std::vector<std::filesystem::path> framesOf(const std::filesystem::path& input, bool sequence);

/// Reads the meshes that the command names, with their transforms.
/// @throws Failure BadInput, also where they have different numbers of frames.
std::vector<Body> readBodies(const ProximityCommand& command, ProgressBar& bar);

/// The number of frames of all bodies together.
std::size_t frameCount(const std::vector<Body>& bodies);

} // namespace medial::app
