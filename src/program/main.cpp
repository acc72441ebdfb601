// Tangled from paper/D-sweeps-and-reliability.md; edit there.
#include <pthread.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <thread>

#include "program/command.hpp"
#include "program/deliver.hpp"
#include "program/exit_status.hpp"
#include "support/freed_memory.hpp"

namespace thermoroll {
namespace {

void await_signal(const sigset_t& signals) {
  int signal = 0;
  sigwait(&signals, &signal);
  stop_output(std::chrono::seconds(1));
  const char* line_end = isatty(STDERR_FILENO) != 0 ? "\n" : "";  // the terminal shows ^C
  const std::string rows =
      rows_written() < 0 ? "" : ", after " + std::to_string(rows_written()) + " rows";
  std::fprintf(stderr, "%sthermoroll: stopped by a signal: %s%s\n", line_end, strsignal(signal),
               rows.c_str());
  std::signal(signal, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  std::raise(signal);
}

/// Have a thread wait for the signals that end the program and are not ignored.
void await_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] { await_signal(signals); }).detach();
}

}  // namespace
}  // namespace thermoroll

int main(int argc, char** argv) {
  // A closed pipe and a file as large as it may be are errors of writing, like a full disk.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  thermoroll::keep_freed_memory();
  try {
    thermoroll::await_signals();
    thermoroll::run(thermoroll::read_command({argv + std::min(argc, 1), argv + argc}));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "thermoroll: %s\n", thermoroll::message_of(error).c_str());
    return thermoroll::status_of(error);
  }
}
