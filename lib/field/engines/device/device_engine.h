#pragma once

#include "field/engines/device/device_field.h"
#include "field/field_engine.h"
#include "gl/gpu_thread.h"

#include <memory>
#include <string>

namespace medial
{

/// Finds closest sites by compute shaders. The host uploads positions and copies results.
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
  using Field = gl::OnGpuThread<DeviceField>;

  std::vector<Crossing> compute(const FieldJob& job, const CrossingSelection* selection,
    FieldSink& sink);
  Field& obtainField(const FieldJob& job);
  static int chooseSlices(const FieldJob& job, Field& field, const FieldSink& sink);

  gl::GpuThread& thread_;
  std::unique_ptr<Field> field_; ///< of the mesh that the engine serves
};

} // namespace medial
