#pragma once

#include "files/scans/scan_reader.h"
#include "files/scans/scan_surface.h"
#include "scan_files.h"

#include <vtkPolyData.h>

#include <string>

// A labelled ball as a scan, and measures of its surface.
namespace medial::test
{

inline constexpr double kRadius = 4.0;
inline constexpr int kLabel = 3;

/// The ball has the label; around it is a shell of another one.
LabelImage ball(bool mirrored = false);

files::ScanSurface ofLabel(long long label);
files::ScanSurface ofValue(double value);

/// Reads a scan from a file with a name and some content.
files::Scan readText(const std::string& name, const std::string& content);

double distanceToCentre(const double* point);

/// Negative where the surface is inside out.
double volumeOf(vtkPolyData* surface);

bool isClosed(vtkPolyData* surface);

} // namespace medial::test
