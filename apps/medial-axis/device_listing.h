#pragma once

#include "medial/device.h"

#include <string>

namespace medial::app
{

/// Returns the answer to --list-devices: what there is to compute on, and what is refused and why.
std::string deviceListing(const DeviceList& list);

} // namespace medial::app
