#include "files/scans/inflate.h"

#include "files/file_content.h"

#include <zlib.h>

#include <algorithm>
#include <limits>

namespace medial::files
{
namespace
{

constexpr int kAnyHeader = 15 + 32; // zlib's or gzip's

class InflateStream
{
public:
  InflateStream()
  {
    if (inflateInit2(&stream_, kAnyHeader) != Z_OK)
    {
      throw std::bad_alloc();
    }
  }
  ~InflateStream() { inflateEnd(&stream_); }
  InflateStream(const InflateStream&) = delete;
  InflateStream& operator=(const InflateStream&) = delete;

  // As zlib's counts have 32 bits, both texts are handed over piece by piece.
  void run(std::string_view from, std::string& to)
  {
    std::size_t taken = 0;
    std::size_t made = 0;
    while (made < to.size())
    {
      constexpr std::size_t kPiece = std::numeric_limits<uInt>::max() / 2;
      const std::size_t in = std::min(from.size() - taken, kPiece);
      const std::size_t out = std::min(to.size() - made, kPiece);
      stream_.next_in =
        const_cast<Bytef*>(reinterpret_cast<const Bytef*>(from.data() + taken)); // zlib's interface
      stream_.avail_in = static_cast<uInt>(in);
      stream_.next_out = reinterpret_cast<Bytef*>(to.data() + made);
      stream_.avail_out = static_cast<uInt>(out);
      const int status = ::inflate(&stream_, Z_NO_FLUSH);
      taken += in - stream_.avail_in;
      made += out - stream_.avail_out;
      const bool ended = status == Z_STREAM_END || (taken == from.size() && stream_.avail_out > 0);
      if (made < to.size() && ended)
      {
        refuseContent("ends early: " + std::to_string(made) + " of " + std::to_string(to.size()) +
          " bytes are there");
      }
      if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
      {
        refuseContent("its compressed values are damaged");
      }
    }
  }

private:
  z_stream stream_{};
};

} // namespace

std::string inflateBytes(std::string_view compressed, std::size_t count)
{
  if (count / kLargestRatio > compressed.size())
  {
    refuseContent("ends early: its header promises " + std::to_string(count) +
      " bytes, and the file has " + std::to_string(compressed.size()) + ", compressed");
  }
  std::string bytes(count, '\0');
  InflateStream().run(compressed, bytes);
  return bytes;
}

} // namespace medial::files
