#include "interrupt.h"

#include "failure.h"

#include <csignal>

namespace medial::app
{
namespace
{

volatile std::sig_atomic_t stopRequested = 0;

void requestStop(int)
{
  stopRequested = 1;
}

} // namespace

void installSignalHandlers()
{
  struct sigaction action = {};
  action.sa_handler = requestStop;
  action.sa_flags = SA_RESTART | SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted()
{
  return stopRequested != 0;
}

void throwIfInterrupted()
{
  if (interrupted())
  {
    throw Failure(ExitCode::Interrupted, "interrupted; nothing was written");
  }
}

} // namespace medial::app
