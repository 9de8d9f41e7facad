#include "evaluate_options.h"
#include "evaluate_run.h"
#include "program_main.h"

int main(int argc, char** argv)
{
  return medial::app::runProgram("medial-evaluate",
    [&]
    {
      if (const auto options = medial::app::parseEvaluateOptions(argc, argv))
      {
        medial::app::runEvaluation(*options);
      }
    });
}
