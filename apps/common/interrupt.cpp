#include "interrupt.h"

#include "failure.h"

#include <csignal>

#include <unistd.h>

namespace medial::app
{
namespace
{

volatile std::sig_atomic_t stopRequested = 0;
volatile std::sig_atomic_t requestedByParent = 0;
volatile std::sig_atomic_t ignored = 0;

void requestStop(int, siginfo_t* info, void*)
{
  requestedByParent = info->si_code == SI_USER && info->si_pid == getppid() ? 1 : 0;
  stopRequested = 1;
}

} // namespace

void installSignalHandlers()
{
  struct sigaction action = {};
  action.sa_sigaction = requestStop;
  action.sa_flags = SA_RESTART | SA_RESETHAND | SA_SIGINFO;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  struct sigaction before = {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) // as nohup sets it
  {
    sigaction(SIGHUP, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

bool interrupted()
{
  return stopRequested != 0 && ignored == 0;
}

bool interruptedByParent()
{
  return interrupted() && requestedByParent != 0;
}

void ignoreInterrupts()
{
  ignored = 1;
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_IGN);
  std::signal(SIGHUP, SIG_IGN);
}

void throwInterrupted(const std::string& who)
{
  throw Failure(ExitCode::Interrupted, who + "interrupted; nothing was written");
}

void throwIfInterrupted()
{
  if (interrupted())
  {
    throwInterrupted();
  }
}

} // namespace medial::app
