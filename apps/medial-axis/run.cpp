#include "run.h"

#include "computation.h"
#include "failure.h"
#include "input/input_file.h"
#include "interrupt.h"
#include "output/standard_output.h"
#include "output_writer.h"
#include "outputs.h"
#include "progress_bar.h"
#include "region_table.h"
#include "report.h"
#include "scan_input.h"
#include "summary.h"
#include "timer.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <filesystem>
#include <string>

namespace medial::app
{
namespace
{

/// @throws Failure Usage for a file in pieces.
void requireOneFile(const std::string& option, const std::filesystem::path& path)
{
  if (extensionOf(path) == ".pvtp")
  {
    throw Failure(ExitCode::Usage,
      option + " " + path.string() +
        ": .pvtp is for several processes, started by mpirun; use .vtp for one");
  }
}

} // namespace

void run(const Options& options)
{
  requireOneFile("INPUT", options.input);
  requireOneFile("--output", options.output);
  requireOneFile("--thickness", options.thickness);
  const Timer total;
  AppSeconds seconds;
  Outputs outputs(options); // what cannot be written is refused before anything is computed
  ProgressBar bar(options.quiet);
  if (options.threads > 0)
  {
    // TBB warns when it is asked for more threads than there are cores.
    vtkSMPTools::Initialize(std::min(options.threads, vtkSMPTools::GetEstimatedNumberOfThreads()));
  }

  bar.show(0.0, "reading");
  Surface surface = readSurface(options.input, options.scan);
  seconds.read = total.seconds();
  throwIfInterrupted();

  const Timer preparing;
  Result result = prepare(surface, options, bar);
  seconds.prepare = preparing.seconds();
  compute(options, outputs.field(), bar, result);
  seconds.measure = result.measureSeconds;
  computeSkeleton(options, bar, result);
  seconds.skeleton = result.skeleton ? result.skeleton->seconds : 0.0;
  // What was made to choose the resolution, and is taken as it is, stands under its own phases.
  seconds.prepare = std::max(0.0, seconds.prepare - result.takenSeconds);
  const Timer thickness;
  computeLocalThickness(options, outputs.localThickness(), outputs.field(), bar, result);
  computeThickness(options, surface, bar, result);
  seconds.thickness = thickness.seconds();

  const Timer writing;
  bar.show(1.0, "writing");
  const OutputNotes notes = writeOutputs(options, surface, result, outputs);
  seconds.pictures = notes.pictureSeconds;
  const auto stop = [&]
  {
    seconds.write = writing.seconds() - seconds.pictures + outputs.fieldSeconds();
    seconds.total = total.seconds();
  };
  stop();
  outputs.write(options.report,
    [&](const auto& file) { writeReport(makeReport(result, options, seconds), file); });
  outputs.commit();
  stop();
  bar.clear();
  printNotes(options, result, notes);
  if (options.report == kStandardOutput)
  {
    printText(makeReport(result, options, seconds));
  }
  else if (!options.quiet)
  {
    printSummary(options, result, notes, seconds);
  }
  requireNoRegions(options, result);
}

} // namespace medial::app
