#pragma once

/// Marks what libmedial exports; everything else in it is hidden.
#define MEDIAL_EXPORT __attribute__((visibility("default")))
