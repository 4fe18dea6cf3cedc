// Ctrl-C and termination, asked for politely: the run stops at the next safe point and can be resumed.
#pragma once

namespace validate {

/// From now on SIGINT and SIGTERM set a flag and interrupt system calls; a second one ends the program at once.
void catch_interrupts();

/// True once a signal has come.
bool interrupted();

}  // namespace validate
