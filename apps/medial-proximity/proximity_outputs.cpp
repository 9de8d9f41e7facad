#include "proximity_outputs.h"

#include "contact_data.h"
#include "files/xml_elements.h"
#include "output/file_writer.h"
#include "output/output_names.h"
#include "output/vtp_writer.h"
#include "proximity_picture.h"
#include "proximity_report.h"

#include <string>

namespace medial::app
{
namespace
{

namespace fs = std::filesystem;

std::string indexOf(const std::vector<fs::path>& pieces)
{
  std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n"
                     "  <Collection>\n";
  for (std::size_t frame = 0; frame < pieces.size(); ++frame)
  {
    text += "    <DataSet timestep=\"" + std::to_string(frame) + "\" file=\"" +
      files::escapedXml(pieces[frame].filename().string()) + "\"/>\n";
  }
  return text + "  </Collection>\n</VTKFile>\n";
}

} // namespace

ProximityOutputs::ProximityOutputs(const ProximityCommand& command)
  : command_(command)
{
  files_.add(command.json);
  files_.add(command.contacts);
  files_.add(command.image);
  if (!command.animation.empty())
  {
    folder_.emplace(command.animation);
  }
}

void ProximityOutputs::addFrames(std::size_t count)
{
  for (std::size_t frame = 0; frame < count; ++frame)
  {
    if (piecesOf(command_.contacts))
    {
      pieces_.push_back(pieceOf(command_.contacts, frame));
      files_.add(pieces_.back());
    }
    if (!command_.animation.empty())
    {
      pictures_.push_back(picturesIn(command_.animation).file(frame));
      files_.add(pictures_.back());
    }
  }
}

void ProximityOutputs::write(const ProximityResults& results, ProgressBar& bar)
{
  this->draw(results, bar);
  bar.show(1.0, "writing");
  this->writeContacts(results);
  files_.write(command_.json,
    [&](const auto& file) { writeFile(file, makeJson(command_, results)); });
}

void ProximityOutputs::writeContacts(const ProximityResults& results)
{
  for (std::size_t frame = 0; frame < pieces_.size(); ++frame)
  {
    files_.write(pieces_[frame],
      [&](const auto& file)
      {
        ContactData data;
        data.addContacts(results.frames[frame].pairs, frame);
        data.addWitnesses(results.frames[frame].pairs, frame);
        writeVtp(data.polyData(), file);
      });
  }
  files_.write(command_.contacts,
    [&](const auto& file)
    {
      if (!pieces_.empty())
      {
        writeFile(file, indexOf(pieces_));
        return;
      }
      ContactData data;
      for (std::size_t frame = 0; frame < results.frames.size(); ++frame)
      {
        data.addContacts(results.frames[frame].pairs, frame);
        data.addWitnesses(results.frames[frame].pairs, frame);
      }
      writeVtp(data.polyData(), file);
    });
}

void ProximityOutputs::draw(const ProximityResults& results, ProgressBar& bar)
{
  if (!command_.image.empty())
  {
    bar.show(0.0, "drawing");
    files_.write(command_.image,
      [&](const auto& file) { ProximityPicture(results, 1).draw(0, file); });
  }
  if (command_.animation.empty())
  {
    return;
  }
  ProximityPicture picture(results, results.frames.size());
  for (std::size_t frame = 0; frame < pictures_.size(); ++frame)
  {
    bar.show(static_cast<double>(frame) / static_cast<double>(pictures_.size()), "drawing");
    files_.write(pictures_[frame], [&](const auto& file) { picture.draw(frame, file); });
  }
}

void ProximityOutputs::commit()
{
  files_.commit();
  if (folder_)
  {
    folder_->commit();
  }
  if (!command_.animation.empty())
  {
    this->removeSurplusPictures();
  }
}

void ProximityOutputs::removeSurplusPictures() const
{
  std::error_code ignored;
  for (std::size_t frame = pictures_.size();
       fs::remove(picturesIn(command_.animation).file(frame), ignored); ++frame)
  {
  }
}

} // namespace medial::app
