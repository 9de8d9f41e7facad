#include "ranks/rank_outputs.h"

#include "input/input_file.h"
#include "interrupt.h"
#include "library_calls.h"
#include "output/file_writer.h"
#include "output/standard_output.h"
#include "output/vtp_writer.h"
#include "ranks/rank_agreement.h"
#include "report.h"
#include "surface_thickness.h"

#include "medial/axis_io.h"

#include <vtkMeshConversion.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <iterator>

namespace medial::app
{
namespace
{

/// Checks a file that is written in pieces or gathered, if it is wanted.
void check(const std::filesystem::path& path, std::optional<SurfacePieces>& pieces,
  std::optional<OutputFile>& whole)
{
  if (extensionOf(path) == ".pvtp")
  {
    pieces.emplace(path);
  }
  else if (!path.empty())
  {
    whole.emplace(path);
  }
}

void writeWhole(const MedialAxis& axis, const std::filesystem::path& path,
  const std::filesystem::path& file)
{
  if (const auto format = axisFormatOf(path))
  {
    writeFile(file, [&](std::ostream& stream) { writeAxis(axis, *format, stream); });
    return;
  }
  vtkNew<vtkPolyData> data;
  vtkMeshConversion::ToPolyData(axis, data);
  writeVtp(data, file);
}

} // namespace

RankOutputs::RankOutputs(const Options& options, Communicator& communicator)
  : options_(options)
  , communicator_(communicator)
{
  withSharedFailures(communicator_,
    [&]
    {
      if (!options.field.empty())
      {
        field_.emplace(options.field, options.fieldArrays);
      }
      check(options.output, axisPieces_, axis_);
      check(options.thickness, thicknessPieces_, thickness_);
      if (!options.thinRegions.empty())
      {
        thinRegions_.emplace(options.thinRegions);
      }
      if (!options.report.empty() && options.report != kStandardOutput)
      {
        report_.emplace(options.report);
      }
    });
}

void RankOutputs::begin(const Grid& grid, const std::vector<Extent>& extents)
{
  withSharedFailures(communicator_,
    [&]
    {
      if (field_)
      {
        std::vector<Extent> touching;
        std::transform(extents.begin(), extents.end(), std::back_inserter(touching),
          [&](const Extent& extent) { return touchingExtent(grid, extent); });
        field_->begin(grid, touching, static_cast<std::size_t>(communicator_.rank()));
      }
    });
}

void RankOutputs::writeAxis(const AxisPiece& axis, const std::vector<std::int64_t>& cells)
{
  MedialAxis whole;
  if (axis_)
  {
    withFailures(options_.input, [&] { whole = gatherMedialAxis(communicator_, axis); });
  }
  withSharedFailures(communicator_,
    [&]
    {
      if (axisPieces_)
      {
        vtkNew<vtkPolyData> data;
        vtkMeshConversion::ToPolyData(axis, data);
        axisPieces_->write(data, cells, static_cast<std::size_t>(communicator_.rank()));
      }
      if (axis_ && this->isFirst())
      {
        namingFile(axis_->path(), [&] { writeWhole(whole, axis_->path(), axis_->open()); });
      }
    });
}

void RankOutputs::writeThickness(const RankThickness& thickness, const Result& result)
{
  withSharedFailures(communicator_,
    [&]
    {
      if (thicknessPieces_)
      {
        thicknessPieces_->write(thickness.piece, thickness.triangles,
          static_cast<std::size_t>(communicator_.rank()));
      }
      const auto write = [this](std::optional<OutputFile>& file, const auto& makeData)
      {
        if (file && this->isFirst())
        {
          namingFile(file->path(), [&] { writeVtp(makeData(), file->open()); });
        }
      };
      write(thickness_, [&] { return result.thicknessSurface; });
      write(thinRegions_, [&] { return regionsOf(result); });
    });
}

void RankOutputs::writeReport(const std::string& text)
{
  withSharedFailures(communicator_,
    [&]
    {
      if (report_ && this->isFirst())
      {
        namingFile(report_->path(), [&] { app::writeReport(text, report_->open()); });
      }
    });
}

void RankOutputs::commit()
{
  withSharedFailures(communicator_, [&] { field_ ? field_->finish() : void(); });
  ignoreInterrupts(); // all files are complete; from here on all of them appear
  withSharedFailures(communicator_,
    [&]
    {
      field_ ? field_->commitPieces() : void();
      axisPieces_ ? axisPieces_->commitPiece() : void();
      thicknessPieces_ ? thicknessPieces_->commitPiece() : void();
    });
  withSharedFailures(communicator_,
    [&]
    {
      field_ ? field_->commitIndex() : void();
      axisPieces_ ? axisPieces_->commitIndex() : void();
      thicknessPieces_ ? thicknessPieces_->commitIndex() : void();
      for (std::optional<OutputFile>* file : { &axis_, &thickness_, &thinRegions_, &report_ })
      {
        if (*file && this->isFirst())
        {
          (*file)->commit();
        }
      }
    });
}

} // namespace medial::app
