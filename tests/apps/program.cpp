#include "program.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace medial::test
{
namespace
{

struct Pipe
{
  int read = -1;
  int write = -1;

  Pipe()
  {
    int ends[2];
    if (pipe(ends) != 0)
    {
      throw std::runtime_error("no pipe");
    }
    read = ends[0];
    write = ends[1];
  }
};

[[noreturn]] void becomeProgram(std::vector<char*>& argv, const RunOptions& options,
  const Pipe& out, const Pipe& err)
{
  dup2(options.output.empty() ? out.write : open(options.output.c_str(), O_WRONLY), STDOUT_FILENO);
  dup2(err.write, STDERR_FILENO);
  for (const Pipe* pipe : { &out, &err })
  {
    close(pipe->read);
    close(pipe->write);
  }
  for (const auto& [name, value] : options.environment)
  {
    setenv(name.c_str(), value.c_str(), 1);
  }
  if (!options.folder.empty() && chdir(options.folder.c_str()) != 0)
  {
    _exit(126);
  }
  if (options.fileSizeLimit > 0)
  {
    const auto limit = static_cast<rlim_t>(options.fileSizeLimit);
    const struct rlimit both = { limit, limit };
    setrlimit(RLIMIT_FSIZE, &both);
  }
  execv(argv[0], argv.data());
  _exit(127);
}

// Whether a process handles SIGINT already: one that is just starting would be ended by it.
bool handlesInterrupts(pid_t process)
{
  const std::string caught = "SigCgt:";
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, caught.size(), caught) == 0)
    {
      const std::uint64_t signals = std::stoull(line.substr(caught.size()), nullptr, 16);
      return (signals >> (SIGINT - 1) & 1) != 0;
    }
  }
  return false;
}

// Reads both pipes until the program has closed them, and interrupts it in between.
void follow(pid_t child, const RunOptions& options, Pipe& out, Pipe& err, Outcome& outcome)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  bool interrupted = options.interruptAfter <= 0.0;
  struct pollfd streams[2] = { { out.read, POLLIN, 0 }, { err.read, POLLIN, 0 } };
  std::string* texts[2] = { &outcome.out, &outcome.err };
  while (streams[0].fd >= 0 || streams[1].fd >= 0)
  {
    poll(streams, 2, 20);
    const std::chrono::duration<double> elapsed = Clock::now() - start;
    if (!interrupted && elapsed.count() >= options.interruptAfter && handlesInterrupts(child))
    {
      kill(child, options.signal);
      interrupted = true;
    }
    for (int i = 0; i < 2; ++i)
    {
      char buffer[4096];
      if (streams[i].fd < 0 || streams[i].revents == 0)
      {
        continue;
      }
      const ssize_t count = ::read(streams[i].fd, buffer, sizeof(buffer));
      if (count > 0)
      {
        texts[i]->append(buffer, static_cast<std::size_t>(count));
      }
      else if (count == 0 || errno != EINTR)
      {
        close(streams[i].fd);
        streams[i].fd = -1;
      }
    }
  }
}

Outcome run(std::string program, const std::vector<std::string>& arguments,
  const RunOptions& options)
{
  std::vector<std::string> words = arguments;
  std::vector<char*> argv{ program.data() };
  for (std::string& word : words)
  {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);

  Pipe out;
  Pipe err;
  const pid_t child = fork();
  if (child == 0)
  {
    becomeProgram(argv, options, out, err);
  }
  close(out.write);
  close(err.write);
  Outcome outcome;
  follow(child, options, out, err, outcome);
  int status = 0;
  waitpid(child, &status, 0);
  outcome.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

} // namespace

Outcome runMedialAxis(const std::vector<std::string>& arguments, const RunOptions& options)
{
  return run(MEDIAL_AXIS_PROGRAM, arguments, options);
}

Outcome runMedialMeasure(const std::vector<std::string>& arguments, const RunOptions& options)
{
  return run(MEDIAL_MEASURE_PROGRAM, arguments, options);
}

Outcome runMedialDistance(const std::vector<std::string>& arguments, const RunOptions& options)
{
  return run(MEDIAL_DISTANCE_PROGRAM, arguments, options);
}

Outcome runMedialProximity(const std::vector<std::string>& arguments, const RunOptions& options)
{
  return run(MEDIAL_PROXIMITY_PROGRAM, arguments, options);
}

Outcome runMedialViewer(const std::vector<std::string>& arguments, const RunOptions& options)
{
  return run(MEDIAL_VIEWER_PROGRAM, arguments, options);
}

} // namespace medial::test
