#pragma once

#include "axis/smooth_curve.h"
