#include "distance_command.h"
#include "distance_run.h"
#include "program_main.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-distance",
    [&]
    {
      if (const auto command = medial::app::parseDistanceCommand(argc, argv))
      {
        medial::app::runDistance(*command);
      }
    });
}
