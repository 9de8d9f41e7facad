#pragma once

#include "medial/distance_field.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace medial
{

/// Lets a second engine go on where a first one has failed: the sink behind it gets every slice
/// once, in slabs of ascending z, however both engines cut the extent.
class ResumedSink : public FieldSink
{
public:
  /// @param extent of the whole job.
  /// @param sink must outlive this.
  ResumedSink(const Extent& extent, FieldSink& sink);

  FieldArrays slabArrays(const Extent& slab) override;
  void stored(const Extent& slab) override;
  std::size_t bytesPerPoint() const override { return sink_.bytesPerPoint(); }

  /// Whether the sink behind it has thrown, so that no engine can go on.
  bool failed() const { return failed_; }

private:
  /// Arrays of a slab that begins before the slices which the sink still needs.
  struct Scratch
  {
    std::vector<float> distance, closestPoint;
    std::vector<std::int32_t> closestSite;
    std::vector<std::uint8_t> closestFeature;
    std::vector<std::int64_t> closestCell;

    FieldArrays resize(std::size_t points, const FieldArrays& wanted);
  };

  void open(const Extent& slab);
  void copySlice(const Extent& from, int slice);

  FieldSink& sink_;
  int next_;                   ///< first slice that the sink has not stored
  std::optional<Extent> open_; ///< slab of the sink that is being filled
  FieldArrays openArrays_;     ///< the sink's, of the slab that was opened last
  bool passing_ = false;       ///< whether the engine writes to them
  FieldArrays scratchArrays_;
  Scratch scratch_;
  bool failed_ = false;
};

} // namespace medial
