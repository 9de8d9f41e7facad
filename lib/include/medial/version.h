#pragma once

/// Version of the library. The build reads it from here.
#define MEDIAL_VERSION "0.1.0"
