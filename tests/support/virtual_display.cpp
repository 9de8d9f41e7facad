#include "support/virtual_display.h"

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace medial::test
{
namespace
{

[[noreturn]] void becomeServer(std::vector<std::string> words, int numberTo)
{
  const int nothing = open("/dev/null", O_WRONLY);
  dup2(nothing, STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
  prctl(PR_SET_PDEATHSIG, SIGTERM); // it does not outlive a test that dies
  words.insert(words.begin(),
    { "Xvfb", "-displayfd", std::to_string(numberTo), "-screen", "0", "1280x1024x24", "-noreset",
      "-nolisten", "tcp" });
  std::vector<char*> argv;
  for (std::string& word : words)
  {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  execvp(argv[0], argv.data());
  _exit(127);
}

// The line that the server writes once it is ready.
std::string readLine(int file)
{
  std::string line;
  char letter = 0;
  while (read(file, &letter, 1) == 1 && letter != '\n')
  {
    line += letter;
  }
  return line;
}

} // namespace

VirtualDisplay::VirtualDisplay(const std::vector<std::string>& arguments)
{
  int ends[2];
  if (pipe(ends) != 0)
  {
    throw std::runtime_error("no pipe");
  }
  server_ = fork();
  if (server_ == 0)
  {
    close(ends[0]);
    becomeServer(arguments, ends[1]);
  }
  close(ends[1]);
  const std::string number = readLine(ends[0]);
  close(ends[0]);
  if (number.empty())
  {
    end();
    throw std::runtime_error("Xvfb does not start (Debian: xvfb)");
  }
  name_ = ":" + number;
  setenv("DISPLAY", name_.c_str(), 1);
}

VirtualDisplay::~VirtualDisplay()
{
  end();
  unsetenv("DISPLAY");
}

void VirtualDisplay::end()
{
  if (server_ > 0)
  {
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    server_ = -1;
  }
}

} // namespace medial::test
