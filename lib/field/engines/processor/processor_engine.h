#pragma once

#include "field/field_engine.h"

namespace medial
{

/// Evaluates the candidates of every tile with the vector instructions of the CPU, on all threads
/// of the job. Needs no OpenGL.
class ProcessorEngine : public FieldEngine
{
public:
  Engine kind() const override { return Engine::Processor; }
  std::optional<Device> device() const override { return {}; }

  void run(const FieldJob& job, FieldSink& sink) override;
  std::vector<Crossing> select(const FieldJob& job, const CrossingSelection& selection,
    FieldSink& sink) override;
};

} // namespace medial
