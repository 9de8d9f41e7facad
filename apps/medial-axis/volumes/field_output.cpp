#include "volumes/field_output.h"

#include "failure.h"
#include "interrupt.h"
#include "output/file_writer.h"
#include "output/output_names.h"
#include "timer.h"
#include "volumes/gzip_file.h"
#include "volumes/vdb_file.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace medial::app
{

FieldOutput::FieldOutput(const fs::path& path, const FieldSelection& selection, const char* scalars,
  double band)
  : path_(path)
  , selection_(selection)
  , scalars_(scalars)
  , band_(band)
{
  const OutputFile check(path);
}

void FieldOutput::begin(const Grid& grid)
{
  const Timer timer;
  if (piecesOf(path_))
  {
    const std::vector<Extent> extents = fieldPieces(grid);
    for (const Extent& extent : extents)
    {
      pieces_.emplace_back(pieceOf(path_, pieces_.size()),
        FieldLayout(grid, extent, selection_, FieldFormat::Vti, scalars_));
    }
    std::vector<std::string> sources;
    for (const Piece& piece : pieces_)
    {
      sources.push_back(piece.file.path().filename().string());
    }
    this->writeIndex(grid, extents, sources);
  }
  else
  {
    pieces_.emplace_back(path_,
      FieldLayout(grid, grid.wholeExtent(), selection_, fieldFormatOf(path_), scalars_));
  }
  std::uint64_t needed = 0;
  for (const Piece& piece : pieces_)
  {
    const FieldFormat format = piece.layout.format();
    const bool isSmaller = format == FieldFormat::Nifti || format == FieldFormat::Vdb;
    needed += isSmaller ? 0 : piece.layout.fileSize();
  }
  this->checkSpace(needed);
  this->writeFrames(grid);
  seconds_ += timer.seconds();
}

void FieldOutput::begin(const Grid& grid, const std::vector<Extent>& extents, std::size_t own)
{
  const Timer timer;
  std::vector<std::string> sources;
  std::vector<Extent> pieces;
  std::uint64_t needed = 0;
  for (std::size_t number = 0; number < extents.size(); ++number)
  {
    if (extents[number].empty())
    {
      continue;
    }
    FieldLayout layout(grid, extents[number], selection_, FieldFormat::Vti, scalars_);
    needed += layout.fileSize();
    pieces.push_back(extents[number]);
    sources.push_back(pieceOf(path_, number).filename().string());
    if (number == own)
    {
      pieces_.emplace_back(pieceOf(path_, number), std::move(layout));
    }
  }
  if (own == 0)
  {
    this->writeIndex(grid, pieces, sources);
  }
  this->checkSpace(needed);
  this->writeFrames(grid);
  seconds_ += timer.seconds();
}

void FieldOutput::writeFrames(const Grid& grid)
{
  for (Piece& piece : pieces_)
  {
    namingFile(piece.file.path(), [&] { this->writeFrame(piece, grid); });
  }
}

void FieldOutput::writeIndex(const Grid& grid, const std::vector<Extent>& extents,
  const std::vector<std::string>& sources)
{
  index_.emplace(path_);
  namingFile(path_,
    [&] { writeFile(index_->open(), fieldIndex(grid, extents, sources, selection_, scalars_)); });
}

// A full disk is better found now than after hours of computing.
void FieldOutput::checkSpace(std::uint64_t needed) const
{
  std::error_code error;
  const fs::space_info space = fs::space(fs::absolute(path_, error).parent_path(), error);
  if (!error && space.capacity > 0 && space.available < needed)
  {
    const auto mebibytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
    throw Failure(ExitCode::NoSpace,
      path_.string() + ": cannot be written: it takes " + mebibytes(needed) + ", and " +
        mebibytes(space.available) + " are free");
  }
}

// Writes everything but the values.
void FieldOutput::writeFrame(Piece& piece, const Grid& grid)
{
  const FieldLayout& layout = piece.layout;
  if (layout.format() == FieldFormat::Nifti)
  {
    piece.data = std::make_unique<GzipFile>(piece.file.open());
  }
  else if (layout.format() == FieldFormat::Vdb)
  {
    piece.data = makeVdbFile(piece.file.open(), grid, band_);
  }
  else
  {
    piece.data = std::make_unique<PositionedFile>(piece.file.open());
  }
  ValueFile& data = *piece.data;
  if (!layout.header().empty())
  {
    data.write(layout.header().data(), layout.header().size(), 0);
  }
  for (std::size_t array = 0; array < kFieldArrays.size(); ++array)
  {
    if (layout.has(array))
    {
      const std::uint64_t size = layout.arraySize(array);
      data.write(&size, layout.lengthSize(), layout.lengthOffset(array));
    }
  }
  if (!layout.footer().empty())
  {
    data.write(layout.footer().data(), layout.footer().size(), layout.footerOffset());
  }
}

FieldArrays FieldOutput::slabArrays(const Extent& slab)
{
  if (slab.pointCount() > capacity_)
  {
    capacity_ = slab.pointCount();
    for (std::size_t array = 0; array < kFieldArrays.size(); ++array)
    {
      const auto bytes = static_cast<std::size_t>(capacity_) * kFieldArrays[array].bytesPerPoint;
      values_[array].reset(); // so that there are never two
      if (selection_[array])
      {
        values_[array].reset(new char[bytes]);
      }
    }
  }
  FieldArrays arrays; // in the order of kFieldArrays
  arrays.distance = reinterpret_cast<float*>(values_[0].get());
  arrays.closestPoint = reinterpret_cast<float*>(values_[1].get());
  arrays.closestCell = reinterpret_cast<std::int64_t*>(values_[2].get());
  arrays.closestFeature = reinterpret_cast<std::uint8_t*>(values_[3].get());
  arrays.closestSite = reinterpret_cast<std::int32_t*>(values_[4].get());
  return arrays;
}

void FieldOutput::stored(const Extent& slab)
{
  const Timer timer;
  for (Piece& piece : pieces_)
  {
    namingFile(piece.file.path(), [&] { this->writeSlab(piece, slab); });
  }
  seconds_ += timer.seconds();
}

// Writes the slices that a piece and a slab have in common, array after array.
void FieldOutput::writeSlab(Piece& piece, const Extent& slab)
{
  const FieldLayout& layout = piece.layout;
  const int first = std::max(slab.min[2], layout.extent().min[2]);
  const int last = std::min(slab.max[2], layout.extent().max[2]);
  if (first > last)
  {
    return;
  }
  for (std::size_t array = 0; array < kFieldArrays.size(); ++array)
  {
    throwIfInterrupted();
    if (!layout.has(array))
    {
      continue;
    }
    const std::uint64_t slice = layout.sliceSize(array);
    piece.data->write(values_[array].get() +
        slice * static_cast<std::uint64_t>(first - slab.min[2]),
      slice * static_cast<std::uint64_t>(last - first + 1), layout.sliceOffset(array, first));
  }
}

std::size_t FieldOutput::bytesPerPoint() const
{
  std::size_t bytes = 0;
  for (std::size_t array = 0; array < kFieldArrays.size(); ++array)
  {
    bytes += selection_[array] ? kFieldArrays[array].bytesPerPoint : 0;
  }
  return bytes;
}

void FieldOutput::finish()
{
  const Timer timer;
  for (auto& values : values_)
  {
    values.reset();
  }
  capacity_ = 0;
  for (Piece& piece : pieces_)
  {
    namingFile(piece.file.path(), [&] { piece.data->close(); });
  }
  seconds_ += timer.seconds();
}

void FieldOutput::commit()
{
  this->commitPieces();
  this->commitIndex();
}

void FieldOutput::commitPieces()
{
  for (Piece& piece : pieces_)
  {
    piece.file.commit();
  }
}

void FieldOutput::commitIndex()
{
  if (index_)
  {
    index_->commit();
  }
}

} // namespace medial::app
