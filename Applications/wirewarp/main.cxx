// SPDX-License-Identifier: BSD-3-Clause
#include "Command.h"

int main(int argc, char** argv)
{
  wirewarp::runCommand(argc, argv);
}
