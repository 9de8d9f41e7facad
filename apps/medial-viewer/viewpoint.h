#pragma once

#include "input/sequence.h"

class vtkRenderer;

namespace medial::app
{

enum class View
{
  Front, ///< of the widest side of the bounds of all frames
  Edge   ///< along its shorter axis
};

/// Shows all frames, above the sliders and beside the scalar bar.
void lookAt(vtkRenderer* renderer, const Sequence& sequence, View view = View::Front);

} // namespace medial::app
