#include "harness/commands/program.h"

int main(int argc, char** argv) { return rtb::RunProgram(argc, argv); }
