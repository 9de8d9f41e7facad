#pragma once

#include "input/sequence.h"

class vtkRenderer;

namespace medial::app
{

/// Looks at the widest side of the bounds of all frames, above the sliders and beside the scalar
/// bar.
void lookAt(vtkRenderer* renderer, const Sequence& sequence);

} // namespace medial::app
