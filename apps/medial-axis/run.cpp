#include "run.h"

#include "axis_writer.h"
#include "computation.h"
#include "field_output.h"
#include "html_page.h"
#include "interrupt.h"
#include "mesh_reader.h"
#include "output_file.h"
#include "picture.h"
#include "progress_bar.h"
#include "report.h"
#include "summary.h"
#include "surface_thickness.h"
#include "thickness_picture.h"

#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <chrono>
#include <functional>
#include <list>
#include <optional>

namespace medial::app
{
namespace
{

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// The outputs that are written after the computation: checked before it starts, given their names
// when all is over.
class Outputs
{
public:
  using Write = std::function<void(const std::filesystem::path&)>;

  void add(const std::filesystem::path& path, Write write)
  {
    if (!path.empty())
    {
      entries_.emplace_back(path, std::move(write));
    }
  }

  void write()
  {
    for (Entry& entry : entries_)
    {
      throwIfInterrupted();
      namingFile(entry.file.path(), [&] { entry.write(entry.file.open()); });
    }
    throwIfInterrupted();
  }

  void commit()
  {
    for (Entry& entry : entries_)
    {
      entry.file.commit();
    }
  }

private:
  struct Entry
  {
    Entry(const std::filesystem::path& path, Write function)
      : file(path)
      , write(std::move(function))
    {
    }

    OutputFile file;
    Write write;
  };

  std::list<Entry> entries_;
};

// The field goes to disk meanwhile.
Result computeFrom(vtkPolyData* mesh, const Options& options, std::optional<FieldOutput>& field,
  ProgressBar& bar)
{
  Result result = prepare(mesh, options);
  if (!field)
  {
    compute(options, nullptr, bar, result);
    computeThickness(options, mesh, bar, result);
    return result;
  }
  field->begin(result.grid);
  compute(options, &*field, bar, result);
  field->finish();
  computeThickness(options, mesh, bar, result);
  return result;
}

} // namespace

void run(const Options& options)
{
  const Clock::time_point start = Clock::now();
  vtkSmartPointer<vtkPolyData> mesh;
  Result result;
  AppSeconds seconds;
  Clock::time_point writeStart;

  std::optional<FieldOutput> field;
  if (!options.field.empty())
  {
    field.emplace(options.field);
  }
  const auto stop = [&]
  {
    seconds.write = secondsSince(writeStart) + (field ? field->seconds() : 0.0);
    seconds.total = secondsSince(start);
  };
  Outputs outputs;
  outputs.add(options.output,
    [&](const auto& file) { writeAxis(result.axis, file, options.output.extension()); });
  outputs.add(options.curves, [&](const auto& file) { writeVtp(result.curves, file); });
  outputs.add(options.image, [&](const auto& file) { drawPicture(mesh, result.axis, file); });
  outputs.add(options.html,
    [&](const auto& file)
    {
      const std::string title = options.input.filename().string();
      result.pageNotes = writeHtml(result.mesh, result.axis, title, file);
    });
  outputs.add(options.thickness,
    [&](const auto& file) { writeVtp(withThickness(mesh, result.mesh, *result.thickness), file); });
  outputs.add(options.thicknessImage,
    [&](const auto& file) { drawThickness(result.thicknessPicture, mesh, file); });
  outputs.add(options.report,
    [&](const auto& file)
    {
      stop();
      writeReport(makeReport(result, options, seconds), file);
    });

  ProgressBar bar(options.quiet);
  if (options.threads > 0)
  {
    vtkSMPTools::Initialize(options.threads);
  }
  bar.show(0.0, "reading");
  mesh = readMesh(options.input);
  seconds.read = secondsSince(start);
  throwIfInterrupted();

  result = computeFrom(mesh, options, field, bar);

  writeStart = Clock::now();
  bar.show(1.0, "writing");
  outputs.write();
  outputs.commit();
  if (field)
  {
    field->commit();
  }
  stop();
  bar.clear();
  if (!options.quiet)
  {
    printSummary(options, result, seconds);
  }
}

} // namespace medial::app
