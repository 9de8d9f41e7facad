#include "options.h"
#include "program_main.h"
#include "run.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-axis",
    [&]
    {
      if (const auto options = medial::app::parseOptions(argc, argv))
      {
        medial::app::run(*options);
      }
    });
}
