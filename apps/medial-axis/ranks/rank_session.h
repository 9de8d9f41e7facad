#pragma once

#include "medial/ranks.h"

#include <functional>
#include <memory>

namespace medial::app
{

/// MPI, from its start to its end, where the program runs as several processes.
class RankSession
{
public:
  /// Starts MPI if a launcher, such as mpirun, has started several processes.
  /// @return null for a single process: it has nothing of MPI.
  static std::unique_ptr<RankSession> start(int& argc, char**& argv);

  virtual ~RankSession() = default;

  virtual Communicator& communicator() = 0;

  /// Runs work that ends alike on every rank. The first rank alone prints. Where an exception
  /// leaves a rank that the others do not know of, prints it and ends all of them.
  virtual void run(const std::function<void()>& work) = 0;
};

} // namespace medial::app
