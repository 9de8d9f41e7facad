#pragma once

#include "field/engines/device/device_field.h"
#include "field/engines/device/split_field.h"
#include "field/field_engine.h"
#include "gl/gpu_thread.h"

#include <memory>
#include <string>

namespace medial
{

/// Finds closest sites by compute shaders. The host uploads positions and copies results; where a
/// mesh or a slice is larger than a storage buffer may be, it also puts those of parts together.
class DeviceEngine : public FieldEngine
{
public:
  /// @param device as DistanceFieldOptions::device.
  /// @throws Error NoGpu without OpenGL.
  explicit DeviceEngine(const std::string& device = {});

  Engine kind() const override { return Engine::Device; }
  std::optional<Device> device() const override { return thread_.device(); }

  void run(const FieldJob& job, FieldSink& sink) override;
  std::vector<Crossing> select(const FieldJob& job, const CrossingSelection& selection,
    FieldSink& sink) override;

private:
  std::vector<Crossing> compute(const FieldJob& job, const CrossingSelection* selection,
    FieldSink& sink);
  void obtainField(const FieldJob& job);
  int chooseSlices(const FieldJob& job, const FieldSink& sink) const;
  /// Number of grid points of the largest slab.
  std::int64_t maxPoints() const;

  gl::GpuThread& thread_;
  ///@{
  /// Of the mesh that the engine serves: one of them, or none before the first job. In parts if the
  /// mesh or a slice of the last grid is larger than a storage buffer.
  std::unique_ptr<DeviceSlabs::Field> field_;
  std::unique_ptr<SplitField> split_;
  ///@}
  std::int64_t bufferLimit_ = 0; ///< bytes
};

} // namespace medial
