// SPDX-License-Identifier: MIT
#include "app/export/jobs.h"

#include "base/files/reason_of.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

namespace polhode {

namespace {

// What a job writes into its pipe: a byte for each piece of work; at the end how it ended, or an error: whose
// fault it is and, until the pipe closes, its text.
constexpr char kBegun = '.', kDone = 'd', kInterrupted = 'i', kError = 'e';

struct Job {
  pid_t process = -1;
  int pipe = -1;
  std::string said;  ///< but for kBegun
};

void say(int pipe, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(pipe, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // nobody listens: the parent is gone, and its death stops this job
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void say_error(int pipe, const Error& error) {
  say(pipe, {std::string{kError, static_cast<char>(error.fault)} + error.text});
}

/// In the child.
[[noreturn]] void run_job(int pipe, pid_t parent, const std::function<Outcome<JobEnd>(const TellJob&)>& job) {
  // A group of its own: Ctrl-C reaches the parent alone, which passes it on once.
  ::setpgid(0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) std::_Exit(1);
  ::signal(SIGPIPE, SIG_IGN);
  try {
    const Outcome<JobEnd> end = job([&] { say(pipe, std::string{kBegun}); });
    if (end)
      say(pipe, std::string{*end == JobEnd::done ? kDone : kInterrupted});
    else
      say_error(pipe, end.error());
  } catch (const std::domain_error& error) {  // a body that cannot be
    say_error(pipe, {error.what(), Fault::invalid});
  } catch (const std::exception& error) {
    say_error(pipe, {error.what()});
  }
  std::_Exit(0);  // what the parent had open is the parent's to close
}

class Jobs {
 public:
  ~Jobs() { stop(), wait(); }

  Done start(const std::function<Outcome<JobEnd>(const TellJob&)>& job) {
    int ends[2];
    if (::pipe(ends) != 0) return cannot_start(errno);
    const pid_t parent = ::getpid();
    const pid_t process = ::fork();
    if (process == 0) {
      ::close(ends[0]);
      for (const Job& other : jobs_) ::close(other.pipe);
      run_job(ends[1], parent, job);
    }
    const int error = errno;
    ::close(ends[1]);
    if (process < 0) {
      ::close(ends[0]);
      return cannot_start(error);
    }
    jobs_.push_back({process, ends[0], {}});
    return done();
  }

  void stop() {
    if (stopped_) return;
    stopped_ = true;
    for (const Job& job : jobs_)
      if (job.process > 0) ::kill(job.process, SIGINT);
  }

  /// Waits a little for something to be said; false when all pipes are closed.
  bool listen(std::size_t& begun) {
    std::vector<pollfd> open;
    for (const Job& job : jobs_)
      if (job.pipe >= 0) open.push_back({job.pipe, POLLIN, 0});
    if (open.empty()) return false;
    constexpr int kPatience_ms = 200;
    if (::poll(open.data(), static_cast<nfds_t>(open.size()), kPatience_ms) > 0)
      for (Job& job : jobs_)
        for (const pollfd& end : open)
          if (end.fd == job.pipe && end.revents != 0) begun += hear(job);
    return true;
  }

  /// The first error, if any job has said all of one or was killed.
  const std::optional<Error>& error() const { return error_; }
  bool interrupted() const { return interrupted_; }

 private:
  static Done cannot_start(int error) {
    return failure_of(Fault::failed, fmt::format("--jobs: no process can be started: {}", reason_of(error)));
  }

  std::size_t hear(Job& job) {
    char bytes[4096];
    const ssize_t count = ::read(job.pipe, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) return 0;
    if (count <= 0) {
      ended(job);
      return 0;
    }
    std::size_t begun = 0;
    for (const char c : std::string_view(bytes, static_cast<std::size_t>(count)))
      if (job.said.empty() && c == kBegun)
        ++begun;
      else
        job.said += c;
    return begun;
  }

  void ended(Job& job) {
    ::close(job.pipe);
    job.pipe = -1;
    int status = 0;
    while (::waitpid(job.process, &status, 0) < 0 && errno == EINTR) {
    }
    job.process = -1;
    const char how = job.said.empty() ? '\0' : job.said[0];
    interrupted_ = interrupted_ || how == kInterrupted;
    if (how == kDone || how == kInterrupted || error_) return;
    if (how == kError && job.said.size() > 1)
      error_ = Error{job.said.substr(2), static_cast<Fault>(job.said[1])};
    else
      error_ = Error{WIFSIGNALED(status)
                         ? fmt::format("--jobs: a process was ended by signal {}", WTERMSIG(status))
                         : std::string("--jobs: a process ended without a word")};
  }

  void wait() {
    for (std::size_t ignored = 0; listen(ignored);) {
    }
  }

  std::vector<Job> jobs_;
  bool stopped_ = false;
  bool interrupted_ = false;
  std::optional<Error> error_;
};

}  // namespace

Outcome<JobEnd> run_jobs(int jobs, const std::function<Outcome<JobEnd>(int job, const TellJob&)>& job,
                         const std::function<void(std::size_t)>& told, const InterruptWatch& watch) {
  std::fflush(nullptr);  // or every child would write it again
  Jobs running;
  for (int i = 0; i < jobs; ++i)
    if (const Done started = running.start([&](const TellJob& tell) { return job(i, tell); }); !started)
      return passed_on(started);
  std::size_t begun = 0;
  while (running.listen(begun)) {
    told(begun);
    if (watch.interrupted() || running.error()) running.stop();
  }
  if (running.error()) return Failure{*running.error()};
  return running.interrupted() ? JobEnd::interrupted : JobEnd::done;
}

}  // namespace polhode
