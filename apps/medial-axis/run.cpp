#include "run.h"

#include "computation.h"
#include "interrupt.h"
#include "output_writer.h"
#include "outputs.h"
#include "progress_bar.h"
#include "report.h"
#include "summary.h"
#include "surface_reader.h"
#include "timer.h"

#include <vtkSMPTools.h>

#include <algorithm>

namespace medial::app
{

void run(const Options& options)
{
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
  Surface surface = readSurface(options.input);
  seconds.read = total.seconds();
  throwIfInterrupted();

  Result result = prepare(surface, options, bar);
  compute(options, outputs.field(), bar, result);
  computeThickness(options, surface, bar, result);

  const Timer writing;
  const auto stop = [&]
  {
    seconds.write = writing.seconds() + outputs.fieldSeconds();
    seconds.total = total.seconds();
  };
  bar.show(1.0, "writing");
  const OutputNotes notes = writeOutputs(options, surface, result, outputs);
  stop();
  outputs.write(options.report,
    [&](const auto& file) { writeReport(makeReport(result, options, seconds), file); });
  outputs.commit();
  stop();
  bar.clear();
  if (!options.quiet)
  {
    printSummary(options, result, notes, seconds);
  }
}

} // namespace medial::app
